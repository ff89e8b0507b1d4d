// SPDX-License-Identifier: GPL-3.0-or-later
#include "temporary_directory.h"
#include "well_formed.h"

#include <annulus/error.h>
#include <apps/formats/text_output.h>
#include <apps/formats/write_csv.h>
#include <apps/formats/write_json.h>
#include <apps/formats/write_pvd.h>
#include <apps/formats/write_vtu.h>
#include <apps/report/summary.h>

#include <zlib.h>

#include <support/catch.h>

#include <array>
#include <cstring>
#include <limits>

using namespace annulus;
using annulus_test::attribute;
using annulus_test::element_content;
using annulus_test::well_formed;

namespace {

std::string decoded_base64(std::string_view text) {
    const std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    std::uint32_t word = 0;
    int have = 0;
    for (const char c : text) {
        if (c == '=') break;
        word = word << 6 | static_cast<std::uint32_t>(digits.find(c));
        have += 6;
        if (have >= 8) out += static_cast<char>(word >> (have -= 8) & 255);
    }
    return out;
}

/// The values of one DataArray: how many blocks, the size of one, that of the last if it is less, their packed sizes;
/// and the blocks.
template <class T>
std::vector<T> array(const std::string& vtu, const std::string& name) {
    const std::string text = element_content(vtu, "Name=\"" + name + "\"");
    const std::string begin = decoded_base64(text.substr(0, 32));
    std::array<std::uint64_t, 3> head{};
    REQUIRE(begin.size() == 24);
    std::memcpy(head.data(), begin.data(), 24);
    const std::size_t header = 8 * (3 + head[0]), encoded = (header + 2) / 3 * 4;
    const std::string lengths = decoded_base64(text.substr(0, encoded));
    REQUIRE(lengths.size() == header);
    std::string packed = decoded_base64(text.substr(encoded)), bytes;
    for (std::uint64_t i = 0; i < head[0]; ++i) {
        std::uint64_t length = 0;
        std::memcpy(&length, lengths.data() + 24 + 8 * i, 8);
        REQUIRE(packed.size() >= length);
        std::string block(i + 1 == head[0] && head[2] != 0 ? head[2] : head[1], '\0');
        uLongf size = block.size();
        REQUIRE(uncompress(reinterpret_cast<Bytef*>(block.data()), &size, reinterpret_cast<const Bytef*>(packed.data()),
                           length) == Z_OK);
        REQUIRE(size == block.size());
        bytes += block;
        packed.erase(0, length);
    }
    REQUIRE(packed.empty());
    std::vector<T> values(bytes.size() / sizeof(T));
    if (!bytes.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
}

Run_record some_run(const std::string& strategy, double seconds) {
    Run_record run;
    run.command = "lloyd";
    run.vertices = 10;
    run.iterations = 2;
    run.strategy = strategy;
    run.tolerance = "certified";
    run.threads = 2;
    run.seed = 18446744073709551615u;
    run.seconds = {seconds, 0.25, 1.5};
    run.moves = {20, 15, 4, 3, 2, 1};
    run.arithmetic.filter = 7;
    run.arithmetic.interval = 6;
    run.arithmetic.exact = 5;
    run.audit = {1, 0};
    return run;
}

}  // namespace

TEST_CASE("vtu: well formed, with every value bit for bit") {
    const std::vector<Coordinates<2>> points = {{0, 0.1}, {1, 5e-324}, {-1, 1}, {2, 2}};
    const std::vector<std::array<Index, 3>> cells = {{0, 1, 2}, {1, 3, 2}};
    const std::vector<double> tolerances = {0.1, std::numeric_limits<double>::infinity(), 0, -1};
    const std::vector<Vtu_field> point_fields = {{"tolerance <\"&>", tolerances},
                                                 {"id", std::vector<std::int64_t>{1, 2, 3, -4}}};
    const std::vector<Vtu_field> cell_fields = {{"angle", std::vector<double>{0.5, 0.75}}};
    const std::string vtu = write_vtu<2>(points, cells, point_fields, cell_fields);
    CHECK(well_formed(vtu));
    CHECK(attribute(vtu, "NumberOfPoints") == "4");
    CHECK(attribute(vtu, "NumberOfCells") == "2");
    CHECK(array<double>(vtu, "Points") == std::vector<double>{0, 0.1, 0, 1, 5e-324, 0, -1, 1, 0, 2, 2, 0});
    CHECK(array<std::int64_t>(vtu, "connectivity") == std::vector<std::int64_t>{0, 1, 2, 1, 3, 2});
    CHECK(array<std::int64_t>(vtu, "offsets") == std::vector<std::int64_t>{3, 6});
    CHECK(array<std::uint8_t>(vtu, "types") == std::vector<std::uint8_t>{5, 5});
    CHECK(array<double>(vtu, "tolerance &lt;&quot;&amp;&gt;") == tolerances);
    CHECK(array<std::int64_t>(vtu, "id") == std::vector<std::int64_t>{1, 2, 3, -4});
    CHECK(array<double>(vtu, "angle") == std::vector<double>{0.5, 0.75});
    CHECK(vtu.find("tolerance") < vtu.find("<CellData>"));
    CHECK(vtu.find("angle") > vtu.find("<CellData>"));

    const std::vector<Coordinates<3>> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const std::vector<std::array<Index, 4>> tetrahedron = {{0, 1, 2, 3}};
    const std::string solid = write_vtu<3>(corners, tetrahedron);
    CHECK(well_formed(solid));
    CHECK(array<std::uint8_t>(solid, "types") == std::vector<std::uint8_t>{10});
    CHECK(array<double>(solid, "Points").at(11) == 1);
    CHECK(well_formed(write_vtu<3>({}, {})));
    // More than one block, and blocks that are full to the last byte.
    for (const std::size_t n : {std::size_t{1} << 15, (std::size_t{1} << 16) + 3}) {
        std::vector<double> many(n);
        for (std::size_t i = 0; i < n; ++i) many[i] = 0.1 * static_cast<double>(i);
        const std::vector<Coordinates<2>> cloud(n);
        const std::vector<Vtu_field> of_cloud{{"many", many}};
        CHECK(array<double>(write_vtu<2>(cloud, {}, of_cloud), "many") == many);
    }
}

TEST_CASE("vtu: fields of a wrong size and cells that name no point are refused") {
    const std::vector<Coordinates<2>> points = {{0, 0}, {1, 0}, {0, 1}};
    const std::vector<std::array<Index, 3>> cells = {{0, 1, 2}};
    const std::vector<Vtu_field> field = {{"f", std::vector<double>{1, 2}}};
    CHECK_THROWS_AS(write_vtu<2>(points, cells, field), Error);
    CHECK_THROWS_AS(write_vtu<2>(points, cells, {}, field), Error);
    const std::vector<std::array<Index, 3>> infinite_cell = {{0, 1, infinite}};
    CHECK_THROWS_AS(write_vtu<2>(points, infinite_cell), Error);
}

TEST_CASE("csv: shortest decimals, empty cells, quotes") {
    Csv_table table;
    table.header = {"a", "b,c", "d\"e"};
    table.rows = {{0.1, std::uint64_t{18446744073709551615u}, std::int64_t{-1}},
                  {Csv_cell(), std::numeric_limits<double>::quiet_NaN(), std::string("x\ny")},
                  {1e300, 5e-324, std::string("plain")}};
    CHECK(write_csv(table) == "a,\"b,c\",\"d\"\"e\"\n0.1,18446744073709551615,-1\n,,\"x\ny\"\n1e+300,5e-324,plain\n");
    table.rows.push_back({1.});
    CHECK_THROWS_AS(write_csv(table), Error);
}

TEST_CASE("summary.json has exactly the promised keys first, in order and nested") {
    const auto json = summary_json(some_run("tolerances", 0.5));
    const std::string text = write_json(json);
    CHECK(text.starts_with(
        "{\n  \"command\": \"lloyd\",\n  \"dimension\": 2,\n  \"vertices\": 10,\n  \"iterations\": 2,\n"
        "  \"strategy\": \"tolerances\",\n  \"tolerance\": \"certified\",\n  \"threads\": 2,\n"
        "  \"seed\": 18446744073709551615,\n"
        "  \"seconds\": {\n    \"triangulation\": 0.5,\n    \"motion\": 0.25,\n    \"total\": 1.5\n  },\n"
        "  \"moves\": {\n    \"asked\": 20,\n    \"within_tolerance\": 15,\n    \"kept_in_place\": 4,\n"
        "    \"flipped\": 3,\n    \"reinserted\": 2,\n    \"rebuilt\": 1\n  },\n"
        "  \"arithmetic\": {\n    \"filter\": 7,\n    \"interval\": 6,\n    \"exact\": 5\n  },\n"
        "  \"audit\": {\n    \"checked\": 1,\n    \"failed\": 0\n  },\n"));
    CHECK(text.ends_with("}\n"));
    CHECK(nlohmann::ordered_json::parse(text) == json);
}

TEST_CASE("compare.json has every ratio of two strategies, of sums and of medians") {
    Comparison_record comparison{{some_run("rebuild", 3), some_run("tolerances", 0.5), some_run("idle", 0)}, true, {}};
    for (Run_record& run : comparison.runs) run.steps.resize(3);
    const auto time = [&](std::size_t run, double first, double second, double third) {
        comparison.runs[run].steps[0].seconds_triangulation = first;
        comparison.runs[run].steps[1].seconds_triangulation = second;
        comparison.runs[run].steps[2].seconds_triangulation = third;
    };
    time(0, 0.5, 2, 0.5);  // the second step has a pause of the machine
    time(1, 0.125, 0.25, 0.125);
    const auto json = compare_json(comparison);
    CHECK(json["ratios_of_medians"]["rebuild/tolerances"] == 4.);
    CHECK(json["ratios_of_medians"]["tolerances/idle"].is_null());
    CHECK(json["ratios_of_medians"].size() == 6);
    CHECK(json["agree"] == true);
    CHECK(json["strategies"]["tolerances"]["seconds"]["triangulation"] == 0.5);
    CHECK(json["ratios"]["rebuild/tolerances"] == 6.);
    CHECK(json["ratios"]["tolerances/rebuild"] == 0.5 / 3);
    CHECK(json["ratios"]["tolerances/idle"].is_null());
    CHECK(json["ratios"].size() == 6);
    comparison.runs.push_back(some_run("tolerances", 1));
    CHECK_THROWS_AS(compare_json(comparison), Error);
    comparison = {{}, false, {"step 3: 5 cells differ"}};
    CHECK(compare_json(comparison)["disagreements"][0] == "step 3: 5 cells differ");
    CHECK(compare_json(comparison)["ratios"].is_object());
}

TEST_CASE("json survives what is no UTF-8 and no number") {
    CHECK(write_json({{"a", "\xff"}, {"b", std::numeric_limits<double>::quiet_NaN()}}) ==
          "{\n  \"a\": \"\xef\xbf\xbd\",\n  \"b\": null\n}\n");
}

TEST_CASE("iterations.csv has a row for each step and empty cells for what was not measured") {
    Run_record run = some_run("tolerances", 1);
    Iteration_record step;
    step.iteration = 1;
    step.seconds_triangulation = 0.5;
    step.seconds_motion = 0.25;
    step.seconds_cumulative = 0.5;
    step.displacement_mean = 0.125;
    step.displacement_max = 2;
    step.moves = {10, 5, 4, 3, 2, 1};
    step.certificates_evaluated = 77;
    step.flips = 8;
    run.steps.push_back(step);
    step.iteration = 2;
    step.tolerance_mean = 0.1;
    step.theta_min = 1e-9;
    run.steps.push_back(step);
    CHECK(write_csv(iterations_table(run)) ==
          "iteration,seconds_triangulation,seconds_motion,seconds_cumulative,displacement_mean,displacement_max,"
          "tolerance_mean,annulus_width_mean,theta_min,asked,within_tolerance,kept_in_place,flipped,reinserted,"
          "rebuilt,filter,interval,exact,certificates_evaluated,flips\n"
          "1,0.5,0.25,0.5,0.125,2,,,,10,5,4,3,2,1,0,0,0,77,8\n"
          "2,0.5,0.25,0.5,0.125,2,0.1,,1e-09,10,5,4,3,2,1,0,0,0,77,8\n");
}

TEST_CASE("a file that is written bit by bit is there when it is whole, beside what a process of the same number left",
          "[io][write]") {
    const annulus_test::Temporary_directory directory;
    const std::string stale = "a.csv.partial-" + std::to_string(::getpid());
    (void)directory.file(stale, "left");
    {
        Text_output out(directory.path() / "a.csv");
        out.write("some");
        CHECK(directory.entries() == 2);
        CHECK_FALSE(std::filesystem::exists(directory.path() / "a.csv"));
    }
    CHECK(directory.entries() == 1);
    Text_output out(directory.path() / "a.csv");
    out.write("some");
    out.commit();
    CHECK(annulus_test::content_of(directory.path() / "a.csv") == "some");
    CHECK(annulus_test::content_of(directory.path() / stale) == "left");
    CHECK(directory.entries() == 2);
}

TEST_CASE("write_pvd names the files of a series and their times", "[io][write]") {
    const std::vector<Pvd_entry> series{{"frame-000000.vtu", 0}, {"a & b.vtu", 120}};
    const std::string pvd = write_pvd(series);
    CHECK(well_formed(pvd));
    CHECK(pvd.find("timestep=\"120\" part=\"0\" file=\"a &amp; b.vtu\"") != std::string::npos);
    CHECK(well_formed(write_pvd({})));
}
