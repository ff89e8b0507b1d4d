// SPDX-License-Identifier: GPL-3.0-or-later
// `annulus-tests '[.climb]'` searches for worse ones (ANNULUS_CLIMB_STEPS, by default 20000) and prints them as lines
// for this list; so do the climbs of every run. Replace the line of the same name.
#include "worst_cases.h"

#include <cstdio>

namespace annulus::testing {

const std::vector<Worst_case>& worst_cases() {
    static const std::vector<Worst_case> all{
        // clang-format off
        {"orientation_2", 0x1.4a61d691bba28p+2,  // 5.1622
         {-0x1.9e5707c572d8cp-2, 0x1.e679635d3257p-2, -0x1.1b604c5b4c7c6p+0, -0x1.2924b9dfc7649p-2,
          0x1.0d5a356bff3c5p-2, -0x1.1f10d3f54dc31p-2}},
        {"orientation_2 roots", 0x1.77d6d64b4fe6cp+1,  // 2.9362
         {-0x1.648b6aed3fcf6p+0, -0x1.eb3584feaec38p-2, -0x1.0000001270828p+0, 0x1.0148c94a01c72p+0,
          -0x1.ffeae8f5492a7p-1, -0x1.00000ae35e63bp+0}},
        {"annulus_2_incircle", 0x1.6de1be0070014p+4,  // 22.8676
         {0x1.1426bc7547095p-4, -0x1.27ed31068da84p-54, -0x1.00000005552dcp+0, -0x1.00000000b7e8cp+0,
          0x1.261db3b8c8577p+0, -0x1.887b24ebd0f28p-1, 0x1.fffff602b7d4fp-1, -0x1.0007168214849p+0}},
        {"annulus_2_norms", 0x1.163d8e21b1fbcp+5,  // 34.7801
         {0x1.8676bad857601p-8, 0x1.7b6e5f6aab3c8p-38, -0x1.00058da9aae4bp+0, 0x1.00000000436cfp+0,
          -0x1.0000b5f6750a4p+0, -0x1.000009e154f19p+0, -0x1.fffff96c24189p-1, -0x1.0000175205c4ap+0}},
        {"orientation_3", 0x1.af02e72413c62p+3,  // 13.4691
         {0x1.67f6ff94f22f5p-3, 0x1.c7cc92f3bfa74p-3, 0x1.cd1ddbd5dff52p-3, 0x1.3143926c3136p+0, -0x1.ceed2d13f90bp-1,
          -0x1.1e8fd6047ed28p-2, -0x1.7ea9bc85d2abdp-1, -0x1.6061eb885a02p-1, -0x1.5885380290e12p-1,
          -0x1.2637c9b69631bp-1, 0x1.4aefa02f12c45p+0, -0x1.b45297488fdf8p-2, 0x1.2dc84d395124ep+0,
          0x1.375fcb116dc61p+0, -0x1.c13f0aa026b04p-1}},
        {"orientation_3_norms", 0x1.0153e62bc7851p+3,  // 8.0415
         {0x1.0019d00830bcbp-1, 0x1.00000003efabp-1, -0x1.0d30661670969p-1, -0x1.000000011e9dp-1,
          -0x1.0616a0040e421p-1, -0x1.0067a28244a36p-1, 0x1.005c2ba621a4dp-1, -0x1.01f3639f786e9p-1,
          0x1.0000001b316bp-1, 0x1.66c485f9e898bp+0, 0x1.896ea09f18a4p-5, 0x1.da9dc04bc94ep-3, -0x1.050adbbc8edfbp-1,
          0x1.26228739bd374p-1, 0x1.00000003cb8b4p-1}},
        {"annulus_3_insphere", 0x1.06aca429c2055p+7,  // 131.3372
         {0x1.617454a17d966p-52, 0x1.1d84293b923bp-44, -0x1.9796225fbb949p-5, -0x1.0000000000a6bp+0,
          -0x1.000000044809bp+0, -0x1.00026c7ecb7bp+0, 0x1.fffffdf359e13p-1, -0x1.000001198fb8cp+0,
          -0x1.001053b541fa2p+0, -0x1.00113968ddd0ep+0, -0x1.000381d7dfc49p+0, 0x1.036af0d706012p+0,
          0x1.f70606682778bp-1, 0x1.00000074e9c75p+0, -0x1.0000062064b15p+0}},
        {"annulus_3_norms", 0x1.d5ac660fb1538p+6,  // 117.4184
         {0x1.00000bb210b92p-1, -0x1.0000000016414p-1, 0x1.000000000003cp-1, -0x1.0e6a2fdeffe1bp-1,
          -0x1.fffffffffff77p-2, -0x1.ffffffffee075p-2, 0x1.0902d05f1df5dp-3, 0x1.000001964ef59p-1,
          0x1.19c4b87d10fdep-1, 0x1.3598ebdd681aep+0, -0x1.49c66d2f59a29p+0, -0x1.f32203a4a72b9p-2,
          -0x1.fffffffe22702p-2, 0x1.0000000e34d6fp-1, -0x1.5e17fa61d5748p-5}},
        {"annulus_3_side", 0x1.57b3cf679240fp+5,  // 42.9628
         {-0x1.84d8f8409e073p-32, -0x1.025d970a33402p-11, 0x1.b1d27de43de03p-11, -0x1.00088c35eba2ap+0,
          -0x1.008db50c4931bp+0, 0x1.00001f1c56264p+0, -0x1.0001cbc30f9c5p+0, -0x1.000000003212bp+0,
          -0x1.000000005e7a6p+0, 0x1.a9c554e655bd4p-1, -0x1.006b911308812p+0, -0x1.00000166714adp+0,
          0x1.0000000c83d27p+0, 0x1.0006a05c75d44p+0, 0x1.ffffffffe29a8p-1}},
        {"triangle, filter gives away", 0x1.532c8db68a89ap+0,  // 1.3249
         {-0x1.52b62ab5eb251p-1, -0x1.73a613f0bd4f5p+0, 0x1.f5bb5b01241b4p-1, 0x1.01f99fc9f07a2p+0,
          0x1.0397557a5bd3fp+0, 0x1.0f0c5752ea938p+0}},
        {"triangle, intervals give away", 0x1.70e17d9b5bec7p-1,  // 0.7205
         {0x1.8f5d00aac6bf9p-4, -0x1.a9c3d3ef0eb29p-2, -0x1.c34e195e71708p-2, 0x1.5b1f8ef9d58a8p-2,
          -0x1.350cd61d1e75ep+0, 0x1.69f38d292eed8p+0}},
        {"bi-cell, filter gives away", 0x1.004df6ed542adp+0,  // 1.0012
         {-0x1.00fcd211cb446p-1, -0x1.e740969f7730ep-2, 0x1.7b9ac082c0b92p+0, -0x1.4515c9c31ed8ap+0,
          -0x1.25ebb367264p+0, -0x1.5bd4075c0d0c2p-1, 0x1.05b92ce516d29p-2, -0x1.00a9b46e8fac4p-1}},
        {"bi-cell, intervals give away", 0x1.50c8cdced1342p-1,  // 0.6578
         {0x1.6a26d4195eb1ep-1, 0x1.3d376f2695711p-2, -0x1.9a95d5f9d2b69p-2, 0x1.1d9921aae9075p-2,
          -0x1.209848cd67c88p-2, 0x1.f68ac6a8ae4cp-1, 0x1.f1ce328cc525bp-2, 0x1.55baf70783f39p-5}},
        {"tetrahedron, filter gives away", 0x1.16b45564e18a5p+0,  // 1.0887
         {-0x1.7458de1a4e384p-42, 0x1.99e94f4700b77p-21, -0x1.242ab1d486244p-20, -0x1.fffcecc276448p-1,
          0x1.17123c6ba79e1p+0, -0x1.0a52183d0704p-1, 0x1.ffffd2fd18ff1p-1, -0x1.00000fbe2d8cfp+0,
          0x1.0000aaac311fp+0, -0x1.000000e0ec601p+0, 0x1.00006cc22a203p+0, -0x1.fffff899d4aaap-1}},
        {"tetrahedron, intervals give away", 0x1.617e9d8dae78ep-1,  // 0.6904
         {0x1.7f0ac6d8c8b8bp+0, 0x1.6a0ead01370f9p-2, 0x1.39657d20fba12p-5, 0x1.d5b4dce7b1701p-4,
          -0x1.1b07aa324fdecp-2, 0x1.15f75ffb43c9dp-3, 0x1.3aa0c7a7af79p+0, -0x1.f8fd4ba1cb0b1p-1,
          -0x1.47ca2b924ae8cp-2, -0x1.2b4031851e511p-4, 0x1.0b997814c9b7ep-1, 0x1.b11840df3aabfp-2}},
        {"bi-cell in space, filter gives away", 0x1.009d7b2be26a8p+0,  // 1.0024
         {-0x1.2da4fa26e1a04p-5, -0x1.e509a13320a27p-1, 0x1.6f20d8d67b8d1p-2, -0x1.6a0732d97d919p-5,
          0x1.f3bd99e5b93b5p-2, -0x1.3bdab80abc274p+0, 0x1.17ca26efd0b9p+0, 0x1.88a1b8c87c41bp-2,
          -0x1.3ada3e2ecd961p+0, -0x1.899c21f73baa9p-2, -0x1.ccb3f66fc9707p-2, 0x1.3e04df2b7a561p-2,
          -0x1.079fae8259104p-2, -0x1.3ef0682a192b6p-1, -0x1.6b2865c7c1439p+0}},
        {"bi-cell in space, intervals give away", 0x1.46ea4fde43e2ap-1,  // 0.6385
         {-0x1.1aedc26c6f539p-17, -0x1.738cda0d6aaedp-1, -0x1.155b71a6219e9p-1, 0x1.3d6124bdc57d1p-2,
          -0x1.7267970b87b39p-1, -0x1.fffff45fba949p-1, 0x1.06c79071ab8b1p+0, 0x1.0000016d49a6ep+0,
          -0x1.00d5b859105abp+0, -0x1.538031b034bbcp+0, 0x1.b86f120962fffp-2, -0x1.96b00cd3c6173p-2,
          0x1.253c1aea4ee4p-1, 0x1.3c455892799afp-2, 0x1.24365add70817p-4}},
        // clang-format on
    };
    return all;
}

double greatest_kept(std::string_view climb) {
    double greatest = 0;
    for (const Worst_case& w : worst_cases())
        if (w.climb == climb) greatest = std::max(greatest, w.reached);
    return greatest;
}

bool report_if_worse(std::string_view climb, double reached, const Numbers& x) {
    if (reached <= greatest_kept(climb)) return false;
    std::printf("worse than any kept in tests/predicate/worst_cases.cpp (%.4f, was %.4f):\n{\"%.*s\", %s,\n %s},\n",
                reached, greatest_kept(climb), static_cast<int>(climb.size()), climb.data(), as_code(reached).c_str(),
                as_code(x).c_str());
    std::fflush(stdout);
    return true;
}

double climb_from_anywhere(std::string_view name, std::size_t dimension, int steps, Random& random) {
    const auto c = std::find_if(climbs().begin(), climbs().end(), [&](const Climb& k) { return k.name == name; });
    if (c == climbs().end()) return NAN;
    double most = 0;
    Numbers worst;
    for (int again = 0; again < 2; ++again) {
        Numbers x = start(c->size, dimension, random);
        const double reached = climb(x, 1.5, random, steps, c->value);
        if (reached >= most) most = reached, worst = x;
    }
    std::printf("greatest error found of %s: %.2f of %g, %.2f kept\n", c->name, most, c->bound, greatest_kept(name));
    (void)report_if_worse(name, most, worst);
    return most <= c->bound ? most : NAN;
}

}  // namespace annulus::testing
