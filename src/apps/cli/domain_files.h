// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/cli/files.h>
#include <apps/cli/mesh_3.h>
#include <apps/formats/mesh_part.h>
#include <apps/motion/cell_quality.h>
#include <apps/report/run_record.h>

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace annulus::inline v1::cli {

/// --domain-as
void add_domain_formats(CLI::App& app, std::vector<std::string>& formats);
/// Throws Error(usage) for formats without --output, and for two that have the same file.
void check_domain_formats(const std::vector<std::string>& formats, const Common_arguments& common);

/// The cells of the domain of an optimised mesh, and what is written of them: domain.mesh, domain.vtu, quality.csv,
/// dihedral.csv, and domain.msh and domain.vtk where --domain-as names them. Refers to the mesh.
class Domain_files {
  public:
    explicit Domain_files(const Mesh_3& mesh);

    /// The ten cells with the least dihedral angles, or all.
    [[nodiscard]] std::vector<Worst_cell> worst() const;
    /// Adds these files, and the fields `domain` and `boundary` of final.vtu.
    void add_to(Run_page<Moving_mesh_3>& page, const Run_record& run, const std::vector<std::string>& formats) const;

  private:
    [[nodiscard]] std::string quality_csv() const;
    [[nodiscard]] std::vector<Vtu_field> point_fields() const;
    [[nodiscard]] std::vector<Vtu_field> cell_fields() const;

    const Mesh_3& mesh_;
    Mesh_part part_;
    std::vector<Cell_quality> quality_;  ///< of its tetrahedra
};

/// Prints the worst cells, a line each.
void print_worst(const Run_record& run);

}  // namespace annulus::inline v1::cli
