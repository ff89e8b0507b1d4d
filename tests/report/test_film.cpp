// SPDX-License-Identifier: GPL-3.0-or-later
// Films: how many pictures they keep.
#include "page_text.h"

#include <formats/temporary_directory.h>
#include <formats/well_formed.h>

#include <annulus/error.h>
#include <apps/formats/markup.h>
#include <apps/report/axis_ticks.h>
#include <apps/report/report.h>
#include <apps/report/summary.h>

#include <support/catch.h>
#include <support/properties.h>

#include <rapidcheck.h>

#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

using namespace annulus;
using annulus::testing::for_all;
using annulus_test::contains;
using annulus_test::grid;
using annulus_test::occurrences;
using annulus_test::Temporary_directory;
using annulus_test::well_formed;
TEST_CASE("A film never has more than its most pictures, the first and the last among them", "[report]") {
    for (const std::uint64_t frames : {1u, 2u, 39u, 40u, 41u, 80u, 81u, 1000u}) {
        Film film;
        std::uint64_t asked = 0;
        for (std::uint64_t i = 0; i < frames; ++i) {
            if (!film.includes(i)) continue;
            ++asked;
            Picture picture = grid(3);
            picture.caption = "Frame " + std::to_string(i) + " & <so on>";
            film.add(i, std::move(picture));
        }
        Picture last = grid(3);
        last.caption = "Frame " + std::to_string(frames - 1) + " & <so on>";
        film.add(frames - 1, std::move(last), true);
        const std::string html = film.html();
        INFO(frames << " frames");
        CHECK(well_formed("<div>" + html.substr(0, html.find("<script>")) + "</div>"));
        const std::size_t shown = occurrences(html, "<svg");
        CHECK(shown <= Film::most_pictures);
        CHECK(shown >= std::min<std::uint64_t>(frames, Film::most_pictures / 2));
        CHECK(asked <= 1000);
        CHECK(contains(html, "Frame 0 &amp; &lt;so on>") + contains(html, "Frame 0 &amp; &lt;so on&gt;") == 1);
        CHECK(contains(html, "Frame " + std::to_string(frames - 1) + " &amp;"));
        CHECK(contains(html, "max=\"" + std::to_string(shown - 1) + "\""));
        CHECK(contains(html, shown < frames ? "of " + grouped(frames) + " frames"
                             : frames == 1  ? "The one frame is shown"
                                            : "All " + grouped(frames) + " frames"));
    }
}

TEST_CASE("Of many vertices a film has a part", "[report]") {
    Film film;
    film.add(0, grid(100));
    film.add(1, grid(100), true);
    const std::string html = film.html();
    CHECK(contains(html, "a window in the middle"));
    CHECK(contains(html, "10,000 vertices"));
    CHECK(html.size() < 300'000);
}
