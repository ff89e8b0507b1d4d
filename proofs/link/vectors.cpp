// SPDX-License-Identifier: GPL-3.0-or-later
// Prints, as Coq, what the compiled certificates compute; proofs/link/check replays it. Usage: vectors KIND COUNT.
// The inputs are the same on every machine: nothing random but a counter.
#include "certificates_2.h"
#include "certificates_3.h"
#include "named.h"
#include "prepared.h"
#include "print.h"
#include "recording.h"

#include <annulus/arithmetic/environment.h>
#include <annulus/arithmetic/rounding_guard.h>
#include <annulus/predicate/batch.h>

#include <cstdlib>
#include <span>
#include <string_view>
#include <vector>

namespace annulus::link {
namespace {

template <class Point, std::size_t k>
std::array<const Point*, k> pointers(const std::array<Point, k>& x) {
    std::array<const Point*, k> out{};
    for (std::size_t i = 0; i < k; ++i) out[i] = &x[i];
    return out;
}

/// One row a case: terms of the filter, and its answers with and without certified tolerances and in a batch.
template <class Certificate>
void filter_rows(const char* constructor, std::size_t count) {
    std::vector<decltype(Certificate::family(0))> points(count);
    std::vector<decltype(pointers(points[0]))> tuples(count);
    for (std::size_t i = 0; i < count; ++i) {
        points[i] = Certificate::family(i);
        tuples[i] = pointers(points[i]);
    }
    using Tuple = typename decltype(tuples)::value_type;
    std::vector<Certificate_value> batch(count);
    evaluate(std::span<const Tuple>(tuples), Tolerance_precision::lower_bound, std::span<Certificate_value>(batch));
    for (std::size_t i = 0; i < count; ++i) {
        const Tuple& x = tuples[i];
        Row row(constructor);
        row.points(points[i]);
        row.numbers(Certificate::terms(x));
        for (const bool certified : {true, false}) {
            Certificate_value v;
            const bool answered = Certificate::filter(x, certified, v);
            row.answer(answered, v);
        }
        row.answer(batch[i].stage == Stage::filter, batch[i]);
        if constexpr (Certificate::d == 3 && Certificate::points == 5) {
            for (const Cell_widths cells : {Cell_widths::always, Cell_widths::never}) {
                Certificate_value v;
                const bool answered = empty_sphere_filter(x, true, v, cells);
                row.answer(answered, v);
            }
        }
    }
}

/// The answers of the interval and the exact stage, whatever the filter says.
template <class Certificate, class Tuple>
void later(Row& row, const Tuple& x) {
    Certificate_value v;
    bool answered = false;
    {
        const Rounding_guard guard(FE_UPWARD);
        answered = Certificate::interval(x, v);
    }
    row.answer(answered, v);
    row.answer(true, Certificate::exact(x));
}

/// What the filtered predicate answers of all of them (batch.h), in the modes lower_bound and correctly_rounded.
template <class Tuple>
class Predicate_answers {
  public:
    explicit Predicate_answers(const std::vector<Tuple>& x) : lower_bound_(x.size()), correctly_rounded_(x.size()) {
        evaluate(std::span<const Tuple>(x), Tolerance_precision::lower_bound,
                 std::span<Certificate_value>(lower_bound_));
        evaluate(std::span<const Tuple>(x), Tolerance_precision::correctly_rounded,
                 std::span<Certificate_value>(correctly_rounded_));
    }
    void answers(Row& row, std::size_t i) const {
        row.answer(true, lower_bound_[i]);
        row.answer(true, correctly_rounded_[i]);
    }

  private:
    std::vector<Certificate_value> lower_bound_, correctly_rounded_;
};

/// Which case row i of the later stages is. Each stage says yes to one of the first few spheres: two are exchanged for
/// later ones.
/// In space without the family of all exponents: integers of 10,000 bits are too much for Coq.
template <class Certificate>
constexpr std::size_t later_case(std::size_t i) {
    if constexpr (Certificate::d == 2) return i;
    if constexpr (Certificate::points == 5) i = i == 0 ? 10 : i == 10 ? 0 : i == 4 ? 19 : i == 19 ? 4 : i;
    return i / 8 * 10 + i % 8;
}

template <class Certificate>
void later_rows(const char* constructor, std::size_t count) {
    std::vector<decltype(Certificate::family(0))> points(count);
    std::vector<decltype(pointers(points[0]))> tuples(count);
    for (std::size_t i = 0; i < count; ++i) {
        points[i] = Certificate::family(later_case<Certificate>(i));
        tuples[i] = pointers(points[i]);
    }
    const Predicate_answers predicate(tuples);
    for (std::size_t i = 0; i < count; ++i) {
        Row row(constructor);
        row.points(points[i]);
        later<Certificate>(row, tuples[i]);
        predicate.answers(row, i);
    }
}

/// The configurations of the published table: all three stages, and the filtered predicate of each alone.
template <class Certificate, class Table>
void named_rows(const char* constructor, const Table& table) {
    for (const auto& n : table) {
        const auto x = pointers(n.x);
        Row row(constructor);
        row.text(n.name);
        row.points(n.x);
        Certificate_value v;
        const bool answered = Certificate::filter(x, true, v);
        row.answer(answered, v);
        later<Certificate>(row, x);
        Predicate_answers(std::vector(1, x)).answers(row, 0);
    }
}

void programs_2() {
    const auto in = [](std::size_t i) {
        return Vector_2<Recorded>{Recorded::input(2 * i), Recorded::input(2 * i + 1)};
    };
    const auto print = [](const char* name, const Width_terms<Recorded>& t) {
        Recorded::print(name, {t.determinant, t.inner, t.outer});
    };
    print("orientation_2_program", orientation_terms(in(0), in(1), in(2)));
    print("annulus_2_program", annulus_terms(in(0), in(1), in(2), in(3)));
}

void programs_3() {
    const auto in = [](std::size_t i) {
        return Vector_3<Recorded>{Recorded::input(3 * i), Recorded::input(3 * i + 1), Recorded::input(3 * i + 2)};
    };
    const auto list = [](const Width_terms<Recorded>& t) {
        return std::vector<Recorded>{t.determinant, t.inner, t.outer};
    };
    Recorded::print("orientation_3_program", list(orientation_terms(in(0), in(1), in(2))));
    const auto t = annulus_terms(in(0), in(1), in(2), in(3));
    std::vector<Recorded> all{t.determinant};
    all.insert(all.end(), t.inner.begin(), t.inner.end());
    all.insert(all.end(), t.outer.begin(), t.outer.end());
    all.insert(all.end(), t.side.begin(), t.side.end());
    all.insert(all.end(), {t.cell_p, t.cell_q});
    Recorded::print("bicell_3_program", all);
    Recorded::print("cell_p_program", list(cell_p_terms(t)));
    Recorded::print("cell_q_program", list(cell_q_terms(t)));
}

void constants_3() {
    Row row("constants_3");
    row.numbers({bounds::orientation_3, bounds::orientation_3_norms, bounds::annulus_3_insphere,
                 bounds::annulus_3_norms, bounds::annulus_3_side, bounds::filter_range_3, bounds::circumsphere_3});
}

void constants_2() {
    Row row("constants_2");
    row.numbers({bounds::u, bounds::orientation_2, bounds::annulus_2_incircle, bounds::annulus_2_norms, bounds::tail,
                 bounds::filter_slack, bounds::filter_range, bounds::circumcircle_2, bounds::interval_slack});
}

int run(std::string_view kind, std::size_t count) {
    require_sound_environment();
    if (kind == "orientation_2") filter_rows<Orientation_2>("Filter_orientation_2", count);
    else if (kind == "empty_sphere_2") filter_rows<Empty_sphere_2>("Filter_empty_sphere_2", count);
    else if (kind == "orientation_2_later") later_rows<Orientation_2>("Later_orientation_2", count);
    else if (kind == "empty_sphere_2_later") later_rows<Empty_sphere_2>("Later_empty_sphere_2", count);
    else if (kind == "named_2") named_rows<Empty_sphere_2>("Named_2", named_2);
    else if (kind == "orientation_3") filter_rows<Orientation_3>("Filter_orientation_3", count);
    else if (kind == "empty_sphere_3") filter_rows<Empty_sphere_3>("Filter_empty_sphere_3", count);
    else if (kind == "orientation_3_later") later_rows<Orientation_3>("Later_orientation_3", count);
    else if (kind == "empty_sphere_3_later") later_rows<Empty_sphere_3>("Later_empty_sphere_3", count);
    else if (kind == "named_3") named_rows<Empty_sphere_3>("Named_3", named_3);
    else if (kind == "prepared_2") prepared_2(count);
    else if (kind == "prepared_3") prepared_3(count);
    else if (kind == "programs_2") programs_2();
    else if (kind == "programs_3") programs_3();
    else if (kind == "constants_2") constants_2();
    else if (kind == "constants_3") constants_3();
    else return 2;
    return 0;
}

}  // namespace
}  // namespace annulus::link

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    return annulus::link::run(argv[1], std::strtoul(argv[2], nullptr, 10));
}
