# SPDX-License-Identifier: GPL-3.0-or-later
# nix-build packaging/nix
{
  pkgs ? import <nixpkgs> { },
}:

pkgs.callPackage ./package.nix { }
