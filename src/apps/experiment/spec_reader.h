// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/input_error.h>

#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace annulus::inline v1 {

/// One table of a TOML file whose keys are read one by one, strictly: every fault is an Input_error with its line and
/// the key.
class Spec_table {
  public:
    Spec_table(const std::string& name, const toml::table& table) : name_(name), table_(table) {}

    /// Refuses every other key.
    void allow(std::initializer_list<std::string_view> keys, const std::string& where) const;
    [[nodiscard]] bool has(std::string_view key) const { return table_.contains(key); }
    [[nodiscard]] const toml::node* find(std::string_view key) const { return table_.get(key); }
    [[nodiscard]] const std::string& name() const { return name_; }

    [[nodiscard]] std::string text(std::string_view key, std::string absent) const;
    [[nodiscard]] bool flag(std::string_view key) const;
    [[nodiscard]] std::uint64_t whole(std::string_view key, std::uint64_t absent, std::uint64_t least,
                                      std::uint64_t most) const;
    /// A value or a list of values; `absent` where there is none. No value may occur twice.
    [[nodiscard]] std::vector<std::string> texts(std::string_view key, std::vector<std::string> absent) const;
    [[nodiscard]] std::vector<std::uint64_t> wholes(std::string_view key, std::vector<std::uint64_t> absent,
                                                    std::uint64_t least, std::uint64_t most) const;
    [[nodiscard]] std::vector<double> numbers(std::string_view key, double least, double most) const;

    /// The fault is at the node, or, where there is none, at the table.
    [[noreturn]] void fail(const toml::node* at, const std::string& fault, const std::string& expected) const;
    [[noreturn]] void fail(std::string_view key, const std::string& fault, const std::string& expected) const {
        fail(find(key), fault, expected);
    }
    /// For a required `key` that is missing.
    void require(std::string_view key, const std::string& expected) const;

  private:
    template <class T, class Read>
    [[nodiscard]] std::vector<T> list(std::string_view key, std::vector<T> absent, Read read) const;
    [[nodiscard]] std::string read_text(std::string_view key, const toml::node& node) const;
    [[nodiscard]] std::uint64_t read_whole(std::string_view key, const toml::node& node, std::uint64_t least,
                                           std::uint64_t most) const;
    [[nodiscard]] double read_number(std::string_view key, const toml::node& node, double least, double most) const;

    const std::string& name_;
    const toml::table& table_;
};

/// A value for display in a message.
[[nodiscard]] std::string shown_value(const toml::node& node);

}  // namespace annulus::inline v1
