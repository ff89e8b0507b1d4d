// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/read_gray_image.h>

namespace annulus::inline v1 {

Gray_image read_pnm(Source source) {
    throw Input_error(Error_code::bad_input, source.name, 0, "is a PBM, PGM or PPM picture",
                      "a PNG or JPEG: this build has no Netpbm, which reads the others");
}

}  // namespace annulus::inline v1
