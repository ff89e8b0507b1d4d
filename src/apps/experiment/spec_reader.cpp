// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/experiment/spec_reader.h>

#include <apps/formats/decimal.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace annulus::inline v1 {

namespace {

std::string quoted(std::string_view key) { return "'" + std::string(key) + "'"; }

std::string range(std::uint64_t least, std::uint64_t most) {
    return "a whole number from " + std::to_string(least) + " to " + std::to_string(most);
}

/// Makes sure that it is not read as a whole number.
std::string shown_double(double x) {
    const std::string text = decimal(x);
    return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
}

}  // namespace

std::string shown_value(const toml::node& node) {
    switch (node.type()) {
        case toml::node_type::string: return shown(node.as_string()->get());
        case toml::node_type::integer: return std::to_string(node.as_integer()->get());
        case toml::node_type::floating_point: return shown_double(node.as_floating_point()->get());
        case toml::node_type::boolean: return node.as_boolean()->get() ? "true" : "false";
        case toml::node_type::array: return node.as_array()->empty() ? "an empty list" : "a list";
        case toml::node_type::table: return "a table";
        default: return "a date or time";
    }
}

void Spec_table::fail(const toml::node* at, const std::string& fault, const std::string& expected) const {
    const toml::source_region where = (at != nullptr ? *at : static_cast<const toml::node&>(table_)).source();
    throw Input_error(Error_code::bad_input, name_, where.begin.line, fault, expected);
}

void Spec_table::allow(std::initializer_list<std::string_view> keys, const std::string& where) const {
    for (const auto& [key, value] : table_) {
        if (std::find(keys.begin(), keys.end(), key.str()) != keys.end()) continue;
        std::string all;
        for (const std::string_view k : keys) all += (all.empty() ? "" : ", ") + std::string(k);
        throw Input_error(Error_code::bad_input, name_, key.source().begin.line,
                          "unknown key " + shown(key.str()) + " in " + where, "one of " + all);
    }
}

void Spec_table::require(std::string_view key, const std::string& expected) const {
    if (!has(key)) fail(nullptr, "no " + quoted(key), expected);
}

std::string Spec_table::read_text(std::string_view key, const toml::node& node) const {
    if (!node.is_string()) fail(&node, quoted(key) + " is " + shown_value(node), "a text in quotes");
    return node.as_string()->get();
}
std::uint64_t Spec_table::read_whole(std::string_view key, const toml::node& node, std::uint64_t least,
                                     std::uint64_t most) const {
    if (!node.is_integer() || node.as_integer()->get() < 0 ||
        static_cast<std::uint64_t>(node.as_integer()->get()) < least ||
        static_cast<std::uint64_t>(node.as_integer()->get()) > most)
        fail(&node, quoted(key) + " is " + shown_value(node), range(least, most));
    return static_cast<std::uint64_t>(node.as_integer()->get());
}
double Spec_table::read_number(std::string_view key, const toml::node& node, double least, double most) const {
    double x = std::nan("");
    if (node.is_integer()) x = static_cast<double>(node.as_integer()->get());
    else if (node.is_floating_point()) x = node.as_floating_point()->get();
    if (!(x >= least && x <= most))
        fail(&node, quoted(key) + " is " + shown_value(node),
             "a number from " + decimal(least) + " to " + decimal(most));
    return x;
}

template <class T, class Read>
std::vector<T> Spec_table::list(std::string_view key, std::vector<T> absent, Read read) const {
    const toml::node* const node = find(key);
    if (node == nullptr) return absent;
    std::vector<T> all;
    std::set<T> seen;
    const auto add = [&](const toml::node& one) {
        T value = read(one);
        if (!seen.insert(value).second)
            fail(&one, quoted(key) + " has " + shown_value(one) + " twice", "each value once");
        all.push_back(std::move(value));
    };
    if (const toml::array* const array = node->as_array()) {
        if (array->empty()) fail(node, quoted(key) + " is an empty list", "a value or more");
        for (const toml::node& one : *array) add(one);
    } else {
        add(*node);
    }
    return all;
}

std::string Spec_table::text(std::string_view key, std::string absent) const {
    const toml::node* const node = find(key);
    return node == nullptr ? absent : read_text(key, *node);
}
bool Spec_table::flag(std::string_view key) const {
    const toml::node* const node = find(key);
    if (node != nullptr && !node->is_boolean()) fail(node, quoted(key) + " is " + shown_value(*node), "true or false");
    return node != nullptr && node->as_boolean()->get();
}
std::uint64_t Spec_table::whole(std::string_view key, std::uint64_t absent, std::uint64_t least,
                                std::uint64_t most) const {
    const toml::node* const node = find(key);
    return node == nullptr ? absent : read_whole(key, *node, least, most);
}
std::vector<std::string> Spec_table::texts(std::string_view key, std::vector<std::string> absent) const {
    return list<std::string>(key, std::move(absent), [&](const toml::node& node) { return read_text(key, node); });
}
std::vector<std::uint64_t> Spec_table::wholes(std::string_view key, std::vector<std::uint64_t> absent,
                                              std::uint64_t least, std::uint64_t most) const {
    return list<std::uint64_t>(key, std::move(absent),
                               [&](const toml::node& node) { return read_whole(key, node, least, most); });
}
std::vector<double> Spec_table::numbers(std::string_view key, double least, double most) const {
    return list<double>(key, {}, [&](const toml::node& node) { return read_number(key, node, least, most); });
}

}  // namespace annulus::inline v1
