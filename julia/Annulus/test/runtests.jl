# SPDX-License-Identifier: GPL-3.0-or-later
# Every function of the package, in 2D and 3D; each error by its code, its words and its vertices.
using Annulus
using Test

const C = Annulus.C

# The same numbers between 0 and 1 with every version of Julia.
function scattered(rows, columns, seed)
    state = Int64(seed)
    x = zeros(rows, columns)
    for k in eachindex(x)
        state = mod(48271 * state, 2147483647)
        x[k] = state / 2147483647
    end
    return x
end

function refusal(call)
    try
        call()
    catch error
        error isa AnnulusError && return error
        rethrow()
    end
    return AnnulusError(C.OK, "", Int32[], Int32[])
end

@testset "creates, moves, inserts, removes, $(d)D" for d in 2:3
    n = 60
    x = scattered(d, n, 11)
    mesh = MovingMesh(x)
    @test dimension(mesh) == affine_dimension(mesh) == d
    @test vertex_count(mesh) == index_bound(mesh) == n
    @test is_vertex(mesh, 1) && is_vertex(mesh, n)
    @test !is_vertex(mesh, 0) && !is_vertex(mesh, n + 1) && !is_vertex(mesh, 2^40) && !is_vertex(mesh, -2^40)
    @test strategy(mesh) == "auto"
    @test vertex_of_input(mesh) == 1:n
    @test points(mesh) == x

    x .+= 1e-4 .* (1 .- 2 .* x)
    @test move!(mesh, x).asked == n
    @test points(mesh) == x
    x[:, n] .= 0.5 .+ x[:, 7] ./ 100
    @test move!(mesh, [n], x[:, n:n]).asked == 1
    @test points(mesh) == x
    recompute_tolerances!(mesh)
    @test length(tolerances(mesh)) == n && all(tolerances(mesh) .> 0) && all(displacements(mesh) .== 0)

    delete!(mesh, [3, 5])
    @test vertex_count(mesh) == n - 2 && index_bound(mesh) == n
    @test !is_vertex(mesh, 3) && is_vertex(mesh, 4) && !is_vertex(mesh, 5)
    @test all(isnan.(points(mesh)[:, 3])) && points(mesh)[:, 4] == x[:, 4]
    more = scattered(d, 3, 77)
    indices, report = insert!(mesh, more)
    @test indices == [5, 3, n + 1] && report isa C.Report
    @test points(mesh)[:, indices] == more
    @test isempty(insert!(mesh, more[:, 1:0]).indices)

    result = audit(mesh)
    @test result.delaunay == 1 && Annulus.fault_text(result) == ""
    @test occursin("$(n + 1) vertices in $(d)D", string(mesh))
    close(mesh)
    close(mesh)
    @test string(mesh) == "MovingMesh, closed"
    @test refusal(() -> move!(mesh, x)).code == C.NULL_POINTER
    none = MovingMesh(zeros(d, 0))
    @test vertex_count(none) == 0 && affine_dimension(none) == -1
end

@testset "neighbours, cells, Voronoi measures, $(d)D" for d in 2:3
    n = 80
    x = scattered(d, n, 5)
    mesh = MovingMesh(x)
    volumes = voronoi_volumes(mesh)
    counts = neighbour_counts(mesh)
    starts, vertices = neighbour_lists(mesh)
    measures, middles = voronoi_facets(mesh)
    others, centroids = voronoi_cells(mesh)
    @test starts[1] == 1 && starts[n + 1] == length(vertices) + 1 == length(measures) + 1
    @test size(middles) == (d, length(measures)) && size(centroids) == (d, n)
    @test count(isfinite, volumes) > 5
    for v in 1:n
        range = starts[v]:(starts[v + 1] - 1)
        @test neighbours(mesh, v) == vertices[range] && length(range) == counts[v]
        if isfinite(volumes[v])  # pyramids over the facets
            pyramids = sum(measures[k] * sqrt(sum(abs2, x[:, vertices[k]] - x[:, v])) / 2d for k in range)
            @test pyramids ≈ volumes[v] ≈ others[v]
        else
            @test !isfinite(others[v]) && isnan(centroids[1, v])
        end
    end
    @test sum(voronoi_cells(mesh; lower=zeros(d), upper=ones(d)).volumes) ≈ 1

    # The gradient by central differences, at one coordinate.
    weights = Float64.(volumes .< 0.05)
    v = vertices[starts[findfirst(weights .> 0)]]
    slope = voronoi_gradient(mesh, weights)[d, v]
    x[d, v] += 1e-6
    move!(mesh, x)
    above = voronoi_volumes(mesh)
    x[d, v] -= 2e-6
    move!(mesh, x)
    difference = sum((above - voronoi_volumes(mesh))[weights .> 0]) / 2e-6
    @test isapprox(difference, slope; atol=1e-5) && slope != 0

    corners, adjacent = cells(mesh)
    @test size(corners, 1) == d + 1 && extrema(corners) == (1, n) && minimum(adjacent) == 0
    @test all(adjacent[i, c] == 0 || c in adjacent[:, adjacent[i, c]] && !(corners[i, c] in corners[:, adjacent[i, c]])
              for i in 1:(d + 1), c in axes(corners, 2))
    middle(c) = sum(x[:, corners[:, c]]; dims=2) ./ (d + 1)
    @test find_cells(mesh, [middle(4) middle(9) fill(9.0, d)]) == [4, 9, 0]
    @test size(convex_hull(mesh)) == (d, count(==(0), adjacent))
end

@testset "numbers that can be verified by hand" begin
    mesh = MovingMesh([0 4 0 4 2; 0 0 4 4 2]; report_changes=true)  # integers become doubles
    @test neighbours(mesh, 5) == [1, 2, 3, 4]
    @test voronoi_volumes(mesh)[5] ≈ 8 && voronoi_volumes(mesh)[1] == Inf
    @test size(convex_hull(mesh), 2) == 4 && !(5 in convex_hull(mesh))
    move!(mesh, [5], [9.0; 2.0][:, :])
    @test size(changed(mesh), 1) == 3 && 5 in changed(mesh) && 0 in changed(mesh)
    @test size(gone(mesh), 1) == 3 && 5 in gone(mesh)
    @test edges_made(mesh) == [2 3]' && edges_broken(mesh) == [1 3; 5 5] && size(t1(mesh)) == (4, 0)
    flip = MovingMesh([0.0 4 0 3; 0 0 4 3]; report_changes=true)
    move!(flip, [4], [5.0; 5.0][:, :])
    @test t1(flip) == [1 4 2 3]'
    line = MovingMesh([0.0 1 2; 0 1 2])
    @test affine_dimension(line) == 1
    @test all(count(==(-1), cells(line).vertices; dims=1) .== 1) && all(cells(line).neighbours .== 0)
    @test vertex_of_input(MovingMesh([0 1 0; 0 0 0]; merge_duplicates=true)) == [1, 2, 1]
    @test strategy(MovingMesh(view(rand(3, 20), 1:2, :); strategy="rebuild", tolerance="certified", threads=2)) ==
          "rebuild"
end

@testset "refusals" begin
    x = [0.0 4 0 3; 0 0 4 3]
    mesh = MovingMesh(x)
    error = refusal(() -> move!(mesh, [2, 4], x[:, [3, 3]]))
    @test error.code == C.DUPLICATE_POINT && error.vertices == [2, 3, 4] && !isempty(error.message)
    @test occursin("duplicate point", sprint(showerror, error)) &&
          occursin("(counted from 1: 2, 3, 4)", sprint(showerror, error))
    for index in (0, 5)
        error = refusal(() -> delete!(mesh, [1, index]))
        @test error.code == C.UNKNOWN_VERTEX && error.vertices == [index] && isempty(error.indices)
    end
    @test refusal(() -> move!(mesh, [NaN * x[:, 1] x[:, 2:4]])).code == C.NOT_FINITE
    @test refusal(() -> move!(mesh, 1e200 * x)).code == C.OUT_OF_DOMAIN
    error = refusal(() -> insert!(mesh, [1.0 2 4; 1 2 0]))
    @test error.code == C.DUPLICATE_POINT && error.vertices == [2] && error.indices == [5, 6]
    @test vertex_count(mesh) == 6
    for call in (() -> move!(mesh, x), () -> move!(mesh, [1], zeros(3, 1)), () -> move!(mesh, [1, 2], x[:, 1:1]),
                 () -> voronoi_gradient(mesh, [1.0]), () -> voronoi_cells(mesh; lower=[0], upper=[1]),
                 () -> in_circle(zeros(2, 3, 1)), () -> audit_cells(x, [1 2; 2 3]))
        @test refusal(call).code == C.WRONG_SIZE
    end
    @test refusal(() -> voronoi_cells(mesh; lower=[0, 0])).code == C.NULL_POINTER
    for list in (changed, gone, edges_made, edges_broken, t1)
        @test refusal(() -> list(mesh)).code == C.USAGE
    end
    @test refusal(() -> MovingMesh(x; strategy="fastest")).code == C.USAGE
    @test refusal(() -> MovingMesh(zeros(1, 1))).code == C.USAGE
    @test refusal(() -> MovingMesh(x[:, [1, 2, 1]])).vertices == [1, 3]
    @test audit(mesh).delaunay == 1
    # Columns that are read while the collector runs.
    for _ in 1:20
        MovingMesh(scattered(3, 30, 4))
        GC.gc(false)
    end
end

@testset "without a mesh" begin
    plane = cat([0.0 1 0 1; 0 0 1 1], [0 1 0 0.9; 0 0 1 0.9]; dims=3)
    space = reshape([0.0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 2, 2, 2], 3, 5, 1)
    @test all(s.sign == 1 && 0.1 < s.tolerance < 0.5 for s in orient_2d(plane[:, 1:3, :]))
    @test [s.sign for s in in_circle(plane)] == [0, 1] && in_circle(plane)[1].tolerance == 0
    @test orient_3d(space[:, 1:4, :])[1].sign == 1
    @test in_sphere(space)[1].sign == -1 && in_sphere(space)[1].theta > 0
    plane[1, 2, 2] = NaN
    @test refusal(() -> in_circle(plane)).vertices == [2]

    x = [0.0 4 0 3; 0 0 4 3]
    @test audit_cells(x, [1 1; 2 4; 4 3]).result.delaunay == 1
    result, faults = audit_cells(x, [1 2; 2 4; 3 3])
    @test result.delaunay == 0 && result.violated_facets == 1 && !isempty(Annulus.fault_text(result))
    @test length(faults) == 1 && faults[1].kind == C.NOT_DELAUNAY && sort(collect(faults[1].cells)) == [1, 2]
    @test isempty(audit_cells(x, [1 2; 2 4; 3 3]; most_faults=0).faults)

    @test Annulus.library_interface() >= C.INTERFACE && occursin(r"^\d+\.\d+", Annulus.library_version())
    pair = zeros(Int32, 2)
    refusal(() -> MovingMesh(x[:, [1, 2, 1]]))
    @test C.annulus_message_vertices(C_NULL, pair) == 2 && pair == [0, 2]
end
