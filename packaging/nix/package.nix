# SPDX-License-Identifier: GPL-3.0-or-later
# The form of nixpkgs (pkgs/by-name); there, src is fetchFromGitHub.
{
  lib,
  stdenv,
  cmake,
  ninja,
  python3,
  boost,
  cgal,
  cli11,
  gmp,
  libjpeg,
  libpng,
  mpfr,
  netpbm,
  nlohmann_json,
  onetbb,
  tomlplusplus,
  zlib,
  withPython ? true,
}:

stdenv.mkDerivation {
  pname = "annulus";
  version = "0.1.0";

  src = lib.cleanSource ../..;

  nativeBuildInputs = [
    cmake
    ninja
    python3
  ];
  buildInputs = [
    boost
    cgal
    cli11
    gmp
    libjpeg
    libpng
    mpfr
    netpbm
    nlohmann_json
    onetbb
    tomlplusplus
    zlib
  ]
  ++ lib.optional withPython python3.pkgs.pybind11;
  propagatedBuildInputs = lib.optional withPython python3.pkgs.numpy;

  cmakeFlags = [
    (lib.cmakeBool "ANNULUS_BUILD_TESTS" false)
    (lib.cmakeBool "ANNULUS_BUILD_BENCH" false)
    (lib.cmakeBool "ANNULUS_BUILD_EXAMPLES" false)
    (lib.cmakeBool "ANNULUS_MPI" false)
    (lib.cmakeBool "ANNULUS_UNITY" true)
    (lib.cmakeBool "ANNULUS_BUILD_PYTHON" withPython)
    (lib.cmakeFeature "Python_EXECUTABLE" python3.interpreter)
    (lib.cmakeFeature "ANNULUS_PYTHON_DIR" python3.sitePackages)
    # Below the prefix, as the files for CMake and pkg-config expect.
    (lib.cmakeFeature "CMAKE_INSTALL_BINDIR" "bin")
    (lib.cmakeFeature "CMAKE_INSTALL_DATADIR" "share")
    (lib.cmakeFeature "CMAKE_INSTALL_INCLUDEDIR" "include")
    (lib.cmakeFeature "CMAKE_INSTALL_LIBDIR" "lib")
    (lib.cmakeFeature "CMAKE_INSTALL_LIBEXECDIR" "libexec")
    (lib.cmakeFeature "CMAKE_INSTALL_MANDIR" "share/man")
  ];

  doInstallCheck = true;
  installCheckPhase = ''
    runHook preInstallCheck
    $out/bin/annulus lloyd --points 100 --iterations 5 --quiet
    runHook postInstallCheck
  '';

  meta = {
    description = "Delaunay triangulations of moving points, certified after every move";
    license = lib.licenses.gpl3Plus;
    platforms = lib.platforms.unix;
    mainProgram = "annulus";
  };
}
