// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace annulus::link {

/// A number type that records how it was computed. A template of src/annulus/predicate instantiated with it prints
/// its own straight-line program, which Coq compares with its model: the order of operations, for all inputs at once.
class Recorded {
  public:
    Recorded() = default;
    /// The i-th input.
    static Recorded input(std::size_t i) { return Recorded(std::make_shared<Node>(Node{"Input", i, {}})); }

    friend Recorded operator+(const Recorded& a, const Recorded& b) { return {"Add", a, b}; }
    friend Recorded operator-(const Recorded& a, const Recorded& b) { return {"Sub", a, b}; }
    friend Recorded operator*(const Recorded& a, const Recorded& b) { return {"Mul", a, b}; }
    friend Recorded max(const Recorded& a, const Recorded& b) { return {"Max", a, b}; }
    friend Recorded operator-(const Recorded& a) { return {"Neg", a}; }

    /// Prints `Definition NAME : list expression := let t0 := ... in [...].`
    static void print(const char* name, const std::vector<Recorded>& results) {
        std::printf("Definition %s : list expression :=\n", name);
        std::size_t count = 0;
        std::vector<const Node*> done;
        for (const Recorded& r : results) r.define(*r.node_, done, count);
        const char* before = "  [";
        for (const Recorded& r : results) {
            std::printf("%st%zu", before, place(r.node_.get(), done));
            before = "; ";
        }
        std::printf("].\n");
    }

  private:
    struct Node {
        const char* operation;
        std::size_t index;  // of an input
        std::vector<std::shared_ptr<Node>> operands;
    };
    explicit Recorded(std::shared_ptr<Node> node) : node_(std::move(node)) {}
    Recorded(const char* operation, const Recorded& a, const Recorded& b)
        : node_(std::make_shared<Node>(Node{operation, 0, {a.node_, b.node_}})) {}

    Recorded(const char* operation, const Recorded& a) : node_(std::make_shared<Node>(Node{operation, 0, {a.node_}})) {}

    static std::size_t place(const Node* n, const std::vector<const Node*>& done) {
        std::size_t i = 0;
        while (i < done.size() && done[i] != n) ++i;
        return i;
    }
    static void define(const Node& n, std::vector<const Node*>& done, std::size_t& count) {
        if (place(&n, done) < done.size()) return;
        for (const auto& o : n.operands) define(*o, done, count);
        if (n.operands.empty()) {
            std::printf("  let t%zu := Input %zu in\n", count, n.index);
        } else {
            std::printf("  let t%zu := %s", count, n.operation);
            for (const auto& o : n.operands) std::printf(" t%zu", place(o.get(), done));
            std::printf(" in\n");
        }
        done.push_back(&n);
        ++count;
    }

    std::shared_ptr<Node> node_;
};

}  // namespace annulus::link
