# SPDX-License-Identifier: GPL-3.0-or-later
# Particles that move, in Julia: volumes of Voronoi cells, neighbours and errors at each step.
# [docs]
using Annulus

x = rand(3, 500)
mesh = MovingMesh(x)
for step in 1:20
    x .+= 1e-4 .* (rand(3, 500) .- 0.5)
    try
        report = move!(mesh, x)
        step == 20 && println(report.within_tolerance + report.kept_in_place, " vertices kept their cells")
    catch error
        error isa AnnulusError && error.code == Annulus.C.DUPLICATE_POINT || rethrow()
        println("separate these vertices: ", error.vertices)  # the mesh is as it was before the step
    end
    volumes = voronoi_volumes(mesh)            # volumes[i]: of the cell of x[:, i], Inf on the hull
    starts, vertices = neighbour_lists(mesh)   # of vertex i: vertices[starts[i]:(starts[i + 1] - 1)]
end
println(sum(neighbour_counts(mesh)) / 500, " neighbours in the mean")
# [docs]
