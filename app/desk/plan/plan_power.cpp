#include "app/desk/plan/plan_power.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

namespace promenade::app {
namespace {

constexpr double wanted_power = 0.8;

PowerRow& row_of(PowerTable& table, const std::string& task, const std::string& measure,
                 const std::string& pair) {
  for (PowerRow& row : table.rows) {
    if (row.task == task && row.measure == measure && row.pair == pair) return row;
  }
  table.rows.push_back({task, measure, pair, std::vector<double>(table.people.size())});
  return table.rows.back();
}

void add_tables(const nlohmann::json& tables, PowerTable& table) {
  for (const nlohmann::json& one : tables) {
    for (const nlohmann::json& row : one.at("rows")) {
      const auto size =
          std::find(table.people.begin(), table.people.end(), row.at("participants").get<int>());
      if (size == table.people.end()) continue;
      const std::string pair =
          row.at("a").get<std::string>() + " – " + row.at("b").get<std::string>();
      row_of(table, one.at("task"), one.at("measure"), pair)
          .power[static_cast<std::size_t>(size - table.people.begin())] = row.at("power");
    }
  }
}

}  // namespace

PowerTable read_power(const std::string& json) {
  PowerTable table;
  const nlohmann::json report = nlohmann::json::parse(json, nullptr, false);
  try {
    table.people = report.at("participants").get<std::vector<int>>();
    add_tables(report.at("tables"), table);
  } catch (const nlohmann::json::exception&) {
    return {};
  }
  return table;
}

int needed_people(const PowerTable& table, const PowerRow& row, double wanted) {
  int needed = 0;
  for (std::size_t i = table.people.size(); i-- > 0 && row.power[i] >= wanted;) {
    needed = table.people[i];
  }
  return needed;
}

void PlanPower::start(const study::Texts& words, int people) {
  std::set<int> sizes;
  for (const double factor : {0.5, 1.0, 1.5, 2.0}) {
    sizes.insert(std::clamp(static_cast<int>(factor * people), 4, 1000));
  }
  std::string list;
  for (const int size : sizes) list += (list.empty() ? "" : ",") + std::to_string(size);
  services_.jobs.start(words("plan.power_working"),
                       {"power", study_.place().file(), "--participants", list, "--jobs", "2",
                        "--studies", "100", "--json"},
                       [this](const Job& job) {
                         if (job.exit_code() == 0) table_ = read_power(job.output());
                       });
}

void PlanPower::draw(const Ui& ui, const study::Texts& words, Column& column, int people) {
  const Palette& palette = ui.look.palette;
  draw_text(ui.look.fonts.title, column.take(36, 4), palette.text, words("plan.power"));
  column.words(ui.look.fonts.text, palette.quiet, words("plan.power_says"), 8);
  if (button(ui, "power", column.take(44), words("plan.power_start"), ButtonKind::outlined,
             study_.bundle() != nullptr && services_.may_work())) {
    start(words, people);
  }
  if (!table_.rows.empty()) draw_table(ui, words, column);
}

// One column for each size, and last the size from which on it is enough.
void PlanPower::draw_table(const Ui& ui, const study::Texts& words, Column& column) const {
  const auto line = [&](const std::string& left, std::vector<std::string> cells, const Rgb& ink) {
    const Box row = column.take(28, 0);
    const float first = 0.42f * row.width;
    draw_line(ui.look.fonts.text, {row.x, row.y, first, row.height}, ink, left);
    const Box rest{row.x + first, row.y, row.width - first, row.height};
    const auto count = static_cast<int>(cells.size());
    for (int i = 0; i < count; ++i) {
      draw_text(ui.look.fonts.text, part_of_row(ui, rest, i, count), ink,
                cells[static_cast<std::size_t>(i)], Align::right);
    }
  };
  std::vector<std::string> sizes;
  for (const int people : table_.people) sizes.push_back(std::to_string(people));
  sizes.push_back(words("plan.needed"));
  line(words("plan.power_of"), sizes, ui.look.palette.quiet);
  std::string heading;
  for (const PowerRow& row : table_.rows) {
    const std::string above = row.task + ": " + row.measure;
    if (above != heading) {
      draw_line(ui.look.fonts.bold, column.take(28, 0), ui.look.palette.text, above);
    }
    heading = above;
    std::vector<std::string> cells;
    for (const double power : row.power) cells.push_back(fmt::format("{:.0f}", 100 * power));
    const int needed = needed_people(table_, row, wanted_power);
    cells.push_back(needed > 0 ? std::to_string(needed) : "–");
    line(row.pair, cells, needed > 0 ? ui.look.palette.text : ui.look.palette.quiet);
  }
}

}  // namespace promenade::app
