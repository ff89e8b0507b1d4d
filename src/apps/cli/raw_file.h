// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/measure/degeneracy.h>
#include <apps/formats/decimal.h>
#include <apps/formats/point_ids.h>
#include <apps/formats/text_output.h>
#include <apps/formats/write_csv.h>

#include <cstdint>
#include <span>
#include <string>

namespace annulus::inline v1::cli {

/// Writes one line per certificate, with the ids of its points.
template <int d>
class Raw_file {
  public:
    Raw_file(const std::string& file, std::span<const std::uint64_t> id, const Point_ids& ids)
        : out_(file), id_(id), ids_(ids) {
        text_ = "kind";
        for (int i = 0; i < d + 2; ++i) text_ += ",point_" + std::to_string(i);
        text_ += ",width_lower,width_upper,tolerance,stage\n";
    }
    void operator()(const Raw_certificate<d>& c) {
        using Kind = typename Raw_certificate<d>::Kind;
        text_ += c.kind == Kind::bicell ? "bicell" : c.kind == Kind::cell ? "cell" : "ridge";
        for (const Index v : c.point) {
            text_ += ',';
            if (v != none) append_csv_text(text_, ids_.text(id_[static_cast<std::size_t>(v)]));
        }
        for (const double x : {c.width_lower, c.width_upper, c.tolerance}) {
            text_ += ',';
            append_decimal(text_, x);
        }
        text_ += ',';
        text_ += name_of(c.stage);
        text_ += '\n';
        if (text_.size() > 1 << 20) flush();
    }
    void commit() {
        flush();
        out_.commit();
    }

  private:
    void flush() {
        out_.write(text_);
        text_.clear();
    }

    Text_output out_;
    std::span<const std::uint64_t> id_;
    const Point_ids& ids_;
    std::string text_;
};

}  // namespace annulus::inline v1::cli
