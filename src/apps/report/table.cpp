// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/decimal.h>
#include <apps/report/table.h>

#include <cmath>

namespace annulus::inline v1 {

namespace {

/// The script turns headings into buttons, so that there are no buttons where scripts do not run.
constexpr const char* script = R"js(
for (const table of document.querySelectorAll("table.sortable")) {
  const body = table.tBodies[0];
  const heads = [...table.tHead.rows[0].cells];
  const rank = (row, column) => {
    const cell = row.cells[column];
    return column > 0 ? parseFloat(cell.dataset.key ?? "NaN") : cell.textContent;
  };
  const compare = (a, b) => typeof a === "string" ? a.localeCompare(b, "en", {numeric: true}) : a - b;
  heads.forEach((head, column) => {
    const button = document.createElement("button");
    button.append(...head.childNodes);
    head.append(button);
    button.addEventListener("click", () => {
      const up = head.getAttribute("aria-sort") !== "ascending";
      for (const other of heads) other.removeAttribute("aria-sort");
      head.setAttribute("aria-sort", up ? "ascending" : "descending");
      const missing = row => Number.isNaN(rank(row, column));
      const rows = [...body.rows].sort((a, b) => missing(a) || missing(b) ? missing(a) - missing(b)
        : (up ? 1 : -1) * compare(rank(a, column), rank(b, column)));
      body.append(...rows);
    });
  });
}
)js";

}  // namespace

void append_table(std::string& out, const std::vector<std::string>& head, const std::vector<Table_row>& rows,
                  bool sortable) {
    out += "<div class=\"scroll\"><table class=\"wide";
    out += sortable ? " sortable\"><thead><tr>" : "\"><thead><tr>";
    for (const std::string& h : head) out += "<th scope=\"col\">" + h + "</th>";
    out += "</tr></thead><tbody>\n";
    for (const Table_row& row : rows) {
        out += "<tr><th scope=\"row\">" + row.front().html + "</th>";
        for (std::size_t i = 1; i < row.size(); ++i) {
            const Table_cell& cell = row[i];
            const bool has_key = sortable && cell.key && std::isfinite(*cell.key);
            out += (has_key ? "<td data-key=\"" + decimal(*cell.key) + "\">" : "<td>") + cell.html + "</td>";
        }
        out += "</tr>\n";
    }
    out += "</tbody></table></div>\n";
}

std::string table_script() { return std::string("<script>") + script + "</script>\n"; }

}  // namespace annulus::inline v1
