// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/reproduction/claim_words.h>

// Section 4.2 of the paper: optimisation of meshes.
namespace annulus {

namespace {

double widths_per_tolerance(const Race_record& r) {
    const Survey_record* s = survey_at(r, r.steps);
    return s && s->paper_tolerance > 0 ? s->width / s->paper_tolerance : 0;
}
double widths_per_certified(const Race_record& r) {
    const Survey_record* s = survey_at(r, r.steps);
    return s && s->certified_tolerance > 0 ? s->width / s->certified_tolerance : 0;
}
double relative_deviation(const Race_record& r) {
    const Survey_record* s = survey_at(r, r.steps);
    return s && s->width > 0 ? s->width_deviation / s->width : 0;
}

void append_speed(const Reproduction& r, std::vector<Claim>& out) {
    const auto space = meshes(r);
    const auto theirs = [](const Race_record& race) { return speed_up(race, "rebuild", "paper"); };
    Claim c{"figure-12", "The filter outperforms rebuilding for most meshes, by so much.",
            "1 to 2",    "",
            "",          Claim_verdict::open,
            ""};
    if (!space.empty()) {
        const auto x = of_each(space, theirs);
        c.theirs = listed(space, theirs, times) +
                   "; with a removal and an insertion for every move that changes cells (computed): " +
                   range(of_each(space,
                                 [](const auto& race) {
                                     const double seconds = seconds_with_relocations(race);
                                     return seconds > 0 ? total_seconds(race, "rebuild") / seconds : 0;
                                 }),
                         times);
        c.ours = listed(
                     space, [](const auto& race) { return speed_up(race, "rebuild", "filter-each"); }, times) +
                 " one vertex at a time; " +
                 listed(
                     space, [](const auto& race) { return speed_up(race, "rebuild", "auto"); }, times) +
                 " (auto)";
        c.verdict = at_least(most(x), 2);
        c.of_long_runs = true;
        c.reason =
            "Our queue tests in place and flips before it takes a vertex out, and our motion comes to rest farther.";
    }
    out.push_back(c);

    c = {"figure-12", "It is faster than relocation by at least so much, in space.", "4", "", "", Claim_verdict::open,
         ""};
    if (!space.empty()) {
        const auto x = of_each(space, [](const auto& race) { return speed_up(race, "relocate", "paper"); });
        c.theirs = listed(
            space, [](const auto& race) { return speed_up(race, "relocate", "paper"); }, times);
        c.ours =
            range(of_each(space, [](const auto& race) { return speed_up(race, "relocate", "filter-each"); }), times) +
            " one vertex at a time";
        c.verdict = at_least(least(x), 4);
        c.of_long_runs = true;
        c.reason = "Relocation is timed at some steps, on copies.";
    }
    out.push_back(c);

    c = {"figure-12", "Relocation against rebuilding is about constant along the iterations.",
         "constant",  "",
         "",          Claim_verdict::open,
         ""};
    if (!space.empty()) {
        const auto drift = [](const Race_record& race) {
            const double early = speed_up_between(race, "rebuild", "relocate", 0, race.steps / 2),
                         late = speed_up_between(race, "rebuild", "relocate", race.steps / 2, race.steps);
            return early > 0 ? late / early : 0;
        };
        const auto x = of_each(space, drift);
        c.theirs = "its speed-up in the second half over that in the first: " + listed(space, drift, times);
        c.ours = "–";
        c.verdict = agree_if(least(x) > 0.75 && most(x) < 1.33);
    }
    out.push_back(c);

    c = {"figure-12", "Switching to the filter pays when so many vertices stay within their tolerance, in space.",
         "55 %",      "",
         "",          Claim_verdict::open,
         ""};
    std::vector<double> found;
    for (const Race_record* race : space)
        if (const auto x = switch_point(*race)) found.push_back(*x);
    if (!space.empty()) {
        c.theirs = found.empty() ? "none: always or never slower than rebuilding" : range(found, percent);
        c.ours = "auto chooses by counts: no fixed share";
        c.verdict = agree_if(!found.empty() && least(found) > 0.4 && most(found) < 0.7);
        c.reason =
            "The point depends on what repair costs beside rebuilding, which is not the paper's, and on the moves: "
            "where few of those that fail change cells repair is cheap.";
    }
    out.push_back(c);

    c = {"figure-12",
         "Rebuilding first, and filtering once a sample of 40 stays within tolerance, gains so much on an organ.",
         "10 %",
         "",
         "",
         Claim_verdict::open,
         ""};
    if (const Race_record* organ = r.race("nodt-heart")) {
        const double gain = 1 - 1 / speed_up(*organ, "paper", "paper-hybrid");
        const Racer_record* hybrid = racer_of(*organ, "paper-hybrid");
        c.theirs = percent(gain) + " of the filter's time; it switched before step " +
                   grouped(hybrid ? hybrid->switched_at : 0);
        c.ours = percent(1 - 1 / speed_up(*organ, "filter-each", "auto")) + " (auto over filter-each)";
        c.of_long_runs = true;
        c.verdict = gain >= 0.2 ? Claim_verdict::further : agree_if(gain > 0.05);
        c.reason = "CGAL's liver in place of the heart.";
    } else if (!space.empty()) {
        c.reason = "Needs the liver: --surfaces.";
    }
    out.push_back(c);
}

void append_statistics(const Reproduction& r, std::vector<Claim>& out) {
    const Race_record *x2 = r.race("lloyd-x2"), *sphere = r.race("nodt-sphere"), *bunny = r.race("nodt-bunny");
    const auto space = meshes(r);
    Claim c{"figure-10", "A vertex in space is in so many bi-cells.", "more than 60", "", "", Claim_verdict::open, ""};
    if (!space.empty()) {
        const auto count = [](const Race_record& race) {
            const Survey_record* s = survey_at(race, 1);
            return s ? s->bicells_a_vertex : 0;
        };
        c.theirs = listed(space, count, readable);
        c.ours = "the same";
        c.verdict = agree_if(most(of_each(space, count)) > 57);
        c.reason =
            "Random points without a border have some 13.5 facets a vertex, and so 68; regular cells and a border have "
            "fewer.";
    }
    out.push_back(c);

    c = {"figure-10", "Widths and tolerances converge in space too.", "yes", "", "", Claim_verdict::open, ""};
    if (sphere && survey_at(*sphere, sphere->steps)) {
        const Survey_record &a = sphere->surveys.front(), &z = *survey_at(*sphere, sphere->steps);
        c.theirs = "sphere: width " + readable(a.width) + " to " + readable(z.width) + ", tolerance " +
                   readable(a.paper_tolerance) + " to " + readable(z.paper_tolerance) + " spacings";
        c.ours = "tolerance " + readable(a.certified_tolerance) + " to " + readable(z.certified_tolerance);
        c.verdict = agree_if(z.width > a.width && z.paper_tolerance > a.paper_tolerance);
    }
    out.push_back(c);

    c = {"figure-10", "Beside the width the tolerance is smaller in space than in the plane.",
         "smaller",   "",
         "",          Claim_verdict::open,
         ""};
    if (x2 && sphere) {
        c.theirs = "widths a tolerance at the end: " + readable(widths_per_tolerance(*x2)) +
                   " in the plane (x squared), " + readable(widths_per_tolerance(*sphere)) + " in space (sphere)";
        c.ours = "by certified tolerances " + readable(widths_per_certified(*x2)) + " and " +
                 readable(widths_per_certified(*sphere));
        c.verdict = agree_if(widths_per_tolerance(*sphere) > widths_per_tolerance(*x2));
    }
    out.push_back(c);

    c = {"figure-10", "Widths scatter more in space than in the plane.", "more", "", "", Claim_verdict::open, ""};
    if (x2 && sphere) {
        const auto one = [&](const Race_record& race) { return readable(relative_deviation(race)); };
        const Race_record* uniform = r.race("lloyd-one");
        c.theirs = "standard deviation over mean at the end: " + one(*sphere) + " on the sphere, " + one(*x2) +
                   " in the plane with x squared" + (uniform ? ", " + one(*uniform) + " with density 1" : "");
        c.ours = "the same";
        c.verdict = agree_if(relative_deviation(*sphere) > relative_deviation(*x2));
        c.reason =
            "With a density that varies cells are of many sizes, which scatters widths in mean spacings; with density "
            "1 they scatter less than on the sphere.";
    }
    out.push_back(c);

    const auto failing = [&](const char* name, const Race_record* race, const char* claimed, double value) {
        Claim f{"figure-11", std::string("Share of moves that fail at the 1,000th iteration: ") + name + ".",
                claimed,     "",
                "",          Claim_verdict::open,
                ""};
        if (race) {
            const double x = failures_at(*race, "paper", race->steps);
            f.theirs = percent(x) + " at iteration " + grouped(race->steps);
            f.ours = percent(failures_at(*race, "filter-each", race->steps)) + " (filter-each)";
            f.of_long_runs = true;
            f.verdict = x < value / 2 ? Claim_verdict::further : agree_if(x < 1.5 * value);
            f.reason =
                "Our motion comes to rest farther: vertices of the surface go in its tangent plane, and three quarters "
                "of the step damp what oscillates there.";
        }
        out.push_back(f);
    };
    failing("bunny", bunny, "25 %", 0.25);
    failing("sphere", sphere, "16 %", 0.16);

    c = {"figure-11",
         "More moves fail for the bunny than for the sphere, and a failure costs more in space than in the plane.",
         "yes",
         "",
         "",
         Claim_verdict::open,
         ""};
    if (bunny && sphere && x2) {
        const auto updates = [](const Race_record& race) { return updates_at(race, "paper", race.steps); };
        c.theirs = "failures " + percent(failures_at(*bunny, "paper", bunny->steps)) + " and " +
                   percent(failures_at(*sphere, "paper", sphere->steps)) + "; updates a failure " +
                   readable(updates(*bunny)) + ", " + readable(updates(*sphere)) + ", in the plane " +
                   readable(updates(*x2));
        c.ours = "updates a failure " + readable(updates_at(*bunny, "filter-each", bunny->steps)) + ", " +
                 readable(updates_at(*sphere, "filter-each", sphere->steps)) + ", " +
                 readable(updates_at(*x2, "filter-each", x2->steps));
        c.verdict =
            agree_if(failures_at(*bunny, "paper", bunny->steps) > failures_at(*sphere, "paper", sphere->steps) &&
                     updates(*bunny) > updates(*x2));
        c.reason = "Ours evaluates the certificates that expired, not all around a vertex.";
    }
    out.push_back(c);
}

void append_quality(const Reproduction& r, std::vector<Claim>& out) {
    const auto space = meshes(r);
    Claim c{"figure-9", "Going from 100 to 1,000 iterations makes the mesh better.", "yes", "", "", Claim_verdict::open,
            ""};
    const Race_record* man = r.race("nodt-man");
    if (!man) man = r.race("nodt-sphere");
    const auto slivers = [](const Quality_record* q) { return q ? static_cast<double>(q->slivers) : 0; };
    if (man && man->steps > 100 && quality_at(*man, 100) && quality_at(*man, man->steps)) {
        const Quality_record &a = *quality_at(*man, 100), &z = *quality_at(*man, man->steps);
        c.theirs = "least dihedral angle " + readable(a.dihedral_min) + " to " + readable(z.dihedral_min) +
                   " degrees, slivers " + grouped(a.slivers) + " to " + grouped(z.slivers);
        c.ours = "the same motion";
        c.verdict = agree_if(z.slivers <= a.slivers);
    }
    out.push_back(c);

    c = {"slivers", "With variable sizing that leaves so many slivers less.", "15 %", "", "", Claim_verdict::open, ""};
    const auto graded = present(r, {"graded-sphere", "graded-bunny"});
    const auto gain = [&](const Race_record& race) {
        const double a = slivers(quality_at(race, 100)), z = slivers(quality_at(race, race.steps));
        return a > 0 ? 1 - z / a : 0;
    };
    if (!graded.empty() && graded.front()->steps > 100) {
        c.theirs = listed(graded, gain, percent);
        c.ours = "the same motion";
        c.verdict = at_least(most(of_each(graded, gain)), 0.15);
        c.reason =
            "A sliver has a dihedral angle below 10 or above 170 degrees; so few are left after 100 iterations that "
            "one more or less is several per cent.";
    }
    out.push_back(c);

    c = {"locked", "Vertices among good cells are locked: in the end so many.", "95 %", "", "", Claim_verdict::open,
         ""};
    const auto locked = present(r, {"locked-sphere", "locked-bunny"});
    const auto resting = [](const Race_record& race) {
        const Quality_record* q = race.qualities.empty() ? nullptr : &race.qualities.back();
        return q && q->vertices > 0 ? static_cast<double>(q->locked) / static_cast<double>(q->vertices) : 0;
    };
    if (!locked.empty()) {
        c.theirs = listed(locked, resting, percent);
        c.ours = "the same motion";
        c.verdict = agree_if(most(of_each(locked, resting)) >= 0.9);
        c.reason =
            "Locked where the dihedral angles of all cells are between 15 and 165 degrees. The paper refines "
            "meanwhile, which we do not.";
    }
    out.push_back(c);

    c = {"figure-8", "Optimised meshes of the four bodies.", "pictures", "", "", Claim_verdict::open, ""};
    if (!space.empty()) {
        c.theirs = c.ours = "pictures of " + grouped(space.size()) + (space.size() == 1 ? " body" : " bodies");
        c.verdict = Claim_verdict::agrees;
        if (space.size() < 4) c.reason = "The others need --surfaces.";
    }
    out.push_back(c);
}

}  // namespace

void append_mesh_claims(const Reproduction& r, std::vector<Claim>& out) {
    append_speed(r, out);
    append_statistics(r, out);
    append_quality(r, out);
}

}  // namespace annulus
