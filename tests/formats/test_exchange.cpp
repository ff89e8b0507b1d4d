// SPDX-License-Identifier: GPL-3.0-or-later
#include "well_formed.h"

#include <annulus/error.h>
#include <apps/formats/write_exchange.h>

#include <support/catch.h>

#include <limits>
#include <string>
#include <vector>

using namespace annulus;

namespace {

const Mesh_part part{{{0, 0, 0}, {1, 0, 0}, {0, 0.1, 0}, {0, 0, 5e-324}}, {{0, 1, 2, 3}}, {{1, 2, 3}, {0, 3, 2}}};
const std::vector<Vtu_field> of_points{{"boundary", std::vector<std::int64_t>{1, 0, 1, -1}}};
const std::vector<Vtu_field> of_cells{{"angle", std::vector<double>{0.5, 60, 1e300}}};

}  // namespace

TEST_CASE("msh 2.2: groups, elements with two tags, views", "[formats][write]") {
    CHECK(write_msh(part, Msh_version::v2_2, of_points, of_cells) ==
          "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
          "$PhysicalNames\n2\n2 2 \"surface\"\n3 1 \"domain\"\n$EndPhysicalNames\n"
          "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 0.1 0\n4 0 0 5e-324\n$EndNodes\n"
          "$Elements\n3\n1 4 2 1 1 1 2 3 4\n2 2 2 2 2 2 3 4\n3 2 2 2 2 1 4 3\n$EndElements\n"
          "$NodeData\n1\n\"boundary\"\n1\n0\n3\n0\n1\n4\n1 1\n2 0\n3 1\n4 -1\n$EndNodeData\n"
          "$ElementData\n1\n\"angle\"\n1\n0\n3\n0\n1\n3\n1 0.5\n2 60\n3 1e+300\n$EndElementData\n");
}

TEST_CASE("msh 4.1: entities with boxes, blocks, all points in one", "[formats][write]") {
    const std::string text = write_msh(part, Msh_version::v4_1, of_points, of_cells);
    CHECK(
        text.starts_with("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
                         "$PhysicalNames\n2\n2 2 \"surface\"\n3 1 \"domain\"\n$EndPhysicalNames\n"
                         "$Entities\n0 0 1 1\n2 0 0 0 1 0.1 5e-324 1 2 0\n1 0 0 0 1 0.1 5e-324 1 1 1 2\n$EndEntities\n"
                         "$Nodes\n1 4 1 4\n3 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n0 0.1 0\n0 0 5e-324\n$EndNodes\n"
                         "$Elements\n2 3 1 3\n3 1 4 1\n1 1 2 3 4\n2 2 2 2\n2 2 3 4\n3 1 4 3\n$EndElements\n"));
    const std::string second = write_msh(part, Msh_version::v2_2, of_points, of_cells);
    CHECK(text.substr(text.find("$NodeData")) == second.substr(second.find("$NodeData")));
    const std::string empty = write_msh({}, Msh_version::v4_1);
    CHECK(empty.find("$Nodes\n0 0 0 0\n$EndNodes\n$Elements\n0 0 0 0\n$EndElements\n") != std::string::npos);
}

TEST_CASE("legacy vtk: tetrahedra, then triangles, with fields", "[formats][write]") {
    CHECK(write_vtk(part, of_points, of_cells) ==
          "# vtk DataFile Version 4.2\nwritten by annulus\nASCII\nDATASET UNSTRUCTURED_GRID\n"
          "POINTS 4 double\n0 0 0\n1 0 0\n0 0.1 0\n0 0 5e-324\n\nCELLS 3 13\n4 0 1 2 3\n3 1 2 3\n3 0 3 2\n\n"
          "CELL_TYPES 3\n10\n5\n5\n\nPOINT_DATA 4\nFIELD FieldData 1\nboundary 1 4 long\n1\n0\n1\n-1\n"
          "\nCELL_DATA 3\nFIELD FieldData 1\nangle 1 3 double\n0.5\n60\n1e+300\n");
    CHECK(write_vtk(part).find("DATA") == write_vtk(part).find("DATASET"));
}

TEST_CASE("vtu of tetrahedra and triangles", "[formats][write]") {
    const std::string vtu = write_vtu(part, of_points, of_cells);
    CHECK(annulus_test::well_formed(vtu));
    CHECK(annulus_test::attribute(vtu, "NumberOfPoints") == "4");
    CHECK(annulus_test::attribute(vtu, "NumberOfCells") == "3");
}

TEST_CASE("what other programs could not read is refused", "[formats][write]") {
    const auto refuse = [](const Mesh_part& bad, const std::vector<Vtu_field>& points,
                           const std::vector<Vtu_field>& cells, Error_code code) {
        const auto expect = [&](const auto& write) {
            try {
                (void)write();
                FAIL("accepted");
            } catch (const Error& e) {
                CHECK(e.code() == code);
            }
        };
        expect([&] { return write_msh(bad, Msh_version::v2_2, points, cells); });
        expect([&] { return write_msh(bad, Msh_version::v4_1, points, cells); });
        expect([&] { return write_vtk(bad, points, cells); });
    };
    Mesh_part bad = part;
    bad.points[2][1] = std::numeric_limits<double>::infinity();
    refuse(bad, {}, {}, Error_code::not_finite);
    bad = part;
    bad.tetrahedra[0][3] = 4;
    refuse(bad, {}, {}, Error_code::unknown_vertex);
    bad = part;
    bad.triangles[1][0] = none;
    refuse(bad, {}, {}, Error_code::unknown_vertex);
    refuse(part, of_cells, {}, Error_code::wrong_size);
    refuse(part, {}, of_points, Error_code::wrong_size);
}
