// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/table_rows.h>
#include <apps/formats/table_survey.h>

#include <algorithm>
#include <limits>

namespace annulus::inline v1 {

namespace {

void examine(Table_rows& rows, Table_survey& survey, std::optional<Frame_value>& last) {
    const Frame_value value = rows.frame();
    if (last && value < *last) survey.in_order = false;
    if (last && *last < value && value.is_number && last->is_number)
        survey.least_distance = std::min(survey.least_distance.value_or(std::numeric_limits<std::uint64_t>::max()),
                                         value.number - last->number);
    survey.numbers_frames = survey.numbers_frames && value.is_number;
    last = value;
    ++survey.rows;
    if (survey.has_integer_ids && !rows.is_absent()) survey.has_integer_ids = rows.has_integer_id();
}

}  // namespace

Table_survey survey_table(File_bytes& bytes, const Column_choice& choice) {
    Table_survey survey;
    try {
        Line_reader reader(bytes);
        Table_rows rows(reader, choice, true);
        std::optional<Frame_value> last;
        while (rows.next()) {
            reader.begin_piece();
            examine(rows, survey, last);
        }
    } catch (const Input_error&) {
    }
    return survey;
}

}  // namespace annulus::inline v1
