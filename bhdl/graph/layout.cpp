// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/graph/layout.h"

#include <algorithm>
#include <unordered_map>

#include "bhdl/source/text.h"

namespace galilean::bhdl {
namespace {

constexpr double kMargin = 24;
constexpr double kColumnGap = 90;
constexpr double kBoxGap = 22;
constexpr double kPassageHeight = 14;
constexpr double kBoxPadding = 20;
constexpr int kSweeps = 8;
// Beyond this number, long arrows are straight: nobody can read such a large picture anyway.
constexpr std::size_t kMostPassages = 20000;

/// A box, or a passage of an arrow, in its column.
struct Node {
  std::size_t column = 0;
  double width = 0;
  double height = 0;
  double x = 0;
  double y = 0;
  double place = 0;  ///< the share of the column's nodes above it
  std::vector<std::size_t> left;
  std::vector<std::size_t> right;
};

using Column = std::vector<std::size_t>;
using Chain = std::vector<std::size_t>;

class GraphBuilder {
 public:
  explicit GraphBuilder(const Program& program) : program_(program) {}

  GraphLayout build() {
    add_boxes();
    find_columns();
    add_arrows();
    for (int sweep = 0; sweep < kSweeps; ++sweep) order(sweep % 2 == 0);
    place();
    return std::move(layout_);
  }

 private:
  void add_boxes() {
    for (const auto& state : program_.states) {
      Box box;
      box.state = &state;
      box.ways = ways_out(state);
      std::size_t characters = character_count(state.name);
      for (const auto& way : box.ways)
        characters = std::max(characters, character_count(way.cause));
      box.width = static_cast<double>(characters) * GraphLayout::kCharacterWidth + kBoxPadding;
      box.height = GraphLayout::kTitleHeight +
                   static_cast<double>(box.ways.size()) * GraphLayout::kRowHeight;
      index_.emplace(state.name, layout_.boxes.size());
      layout_.boxes.push_back(std::move(box));
    }
  }

  // Columns are found breadth first from the start state. States that it does not reach begin at
  // the left, too.
  void find_columns() {
    std::vector<bool> seen(layout_.boxes.size(), false);
    spread(index_.at(program_.start_state), seen);
    for (std::size_t i = 0; i < layout_.boxes.size(); ++i)
      if (!seen[i]) spread(i, seen);
  }

  void spread(std::size_t root, std::vector<bool>& seen) {
    std::vector<std::size_t> queue{root};
    seen[root] = true;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const Box& box = layout_.boxes[queue[i]];
      add_node(box.column, box.width, box.height);
      node_of_box_[queue[i]] = nodes_.size() - 1;
      for (const auto& way : box.ways) {
        const std::size_t next = index_.at(way.to);
        if (seen[next]) continue;
        seen[next] = true;
        layout_.boxes[next].column = box.column + 1;
        queue.push_back(next);
      }
    }
  }

  void add_node(std::size_t column, double node_width, double height) {
    if (column >= columns_.size()) columns_.resize(column + 1);
    columns_[column].push_back(nodes_.size());
    Node node;
    node.column = column;
    node.width = node_width;
    node.height = height;
    nodes_.push_back(std::move(node));
  }

  void add_arrows() {
    for (std::size_t from = 0; from < layout_.boxes.size(); ++from)
      for (std::size_t way = 0; way < layout_.boxes[from].ways.size(); ++way)
        add_arrow(from, way, index_.at(layout_.boxes[from].ways[way].to));
  }

  void add_arrow(std::size_t from, std::size_t way, std::size_t to) {
    const std::size_t start = layout_.boxes[from].column;
    const std::size_t goal = layout_.boxes[to].column;
    const std::size_t columns = start < goal ? goal - start : start - goal;
    Chain chain;
    std::size_t last = node_of_box_[from];
    if (columns > 1 && passages_ + columns <= kMostPassages) {
      for (std::size_t i = 1; i < columns; ++i) {
        add_node(start < goal ? start + i : start - i, 0, kPassageHeight);
        chain.push_back(nodes_.size() - 1);
        join(last, chain.back());
        last = chain.back();
      }
      passages_ += columns - 1;
    }
    if (columns > 0) join(last, node_of_box_[to]);
    layout_.arrows.push_back({from, way, to, {}});
    chains_.push_back(std::move(chain));
  }

  void join(std::size_t a, std::size_t b) {
    if (nodes_[a].column > nodes_[b].column) std::swap(a, b);
    nodes_[a].right.push_back(b);
    nodes_[b].left.push_back(a);
  }

  void order(bool rightwards) {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      Column& column = columns_[rightwards ? i : columns_.size() - 1 - i];
      for (std::size_t rank = 0; rank < column.size(); ++rank)
        nodes_[column[rank]].place = static_cast<double>(rank);
      for (const std::size_t each : column) {
        const auto& neighbours = rightwards ? nodes_[each].left : nodes_[each].right;
        if (!neighbours.empty()) nodes_[each].place = mean_place(neighbours);
      }
      std::ranges::stable_sort(column, {}, [&](std::size_t each) { return nodes_[each].place; });
      for (std::size_t rank = 0; rank < column.size(); ++rank)
        nodes_[column[rank]].place = static_cast<double>(rank) / static_cast<double>(column.size());
    }
  }

  [[nodiscard]] double mean_place(const std::vector<std::size_t>& neighbours) const {
    double sum = 0;
    for (const std::size_t each : neighbours) sum += nodes_[each].place;
    return sum / static_cast<double>(neighbours.size());
  }

  void place() {
    double tallest = 0;
    for (const auto& column : columns_) tallest = std::max(tallest, height(column));
    double x = kMargin;
    for (const auto& column : columns_) {
      const double widest = column_width(column);
      double y = kMargin + (tallest - height(column)) / 2;
      for (const std::size_t each : column) {
        Node& node = nodes_[each];
        node.x = x;
        node.y = y;
        if (node.width == 0) node.width = widest;
        y += node.height + kBoxGap;
      }
      x += widest + kColumnGap;
    }
    layout_.width = x - kColumnGap + kMargin + kColumnGap / 2;
    layout_.height = tallest + 2 * kMargin;
    copy_places();
  }

  [[nodiscard]] double height(const Column& column) const {
    double sum = -kBoxGap;
    for (const std::size_t each : column) sum += nodes_[each].height + kBoxGap;
    return sum;
  }

  [[nodiscard]] double column_width(const Column& column) const {
    double widest = 0;
    for (const std::size_t each : column) widest = std::max(widest, nodes_[each].width);
    return widest;
  }

  void copy_places() {
    for (std::size_t i = 0; i < layout_.boxes.size(); ++i) {
      layout_.boxes[i].x = nodes_[node_of_box_[i]].x;
      layout_.boxes[i].y = nodes_[node_of_box_[i]].y;
    }
    for (std::size_t i = 0; i < chains_.size(); ++i)
      for (const std::size_t each : chains_[i])
        layout_.arrows[i].passages.push_back(
            {nodes_[each].x, nodes_[each].y + nodes_[each].height / 2, nodes_[each].width});
  }

  const Program& program_;
  GraphLayout layout_;
  std::unordered_map<std::string_view, std::size_t> index_;
  std::unordered_map<std::size_t, std::size_t> node_of_box_;
  std::vector<Node> nodes_;
  std::vector<Column> columns_;
  std::vector<Chain> chains_;  ///< for each arrow, the nodes of its passages
  std::size_t passages_ = 0;
};

}  // namespace

GraphLayout lay_out_graph(const Program& program) {
  return GraphBuilder(program).build();
}

}  // namespace galilean::bhdl
