// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/formats/read_points.h>
#include <annulus/statistics/histogram.h>

#include <iostream>

int main() {
    try {
        (void)annulus::read_points<3>("there-is-no-such-file.xyz");
    } catch (const annulus::Error& e) {
        std::cout << "consumer: " << e.what() << "\n";
        return 0;
    }
    return 1;
}
