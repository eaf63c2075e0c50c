// A list of people, studies, codes: headings, and below them rows that the wheel scrolls.
#pragma once

#include <span>

#include "app/scroll_area.h"
#include "app/widgets.h"
#include "study/texts.h"

namespace promenade::app {

struct TableColumn {
  const char* heading;  // key of its words
  float from, to;       // of the row's width, 0 to 1
};

// The column's part of a row.
inline Box cell_of(const Box& row, const TableColumn& column) {
  constexpr float gap = 0.01f;
  return {row.x + column.from * row.width, row.y, (column.to - column.from - gap) * row.width,
          row.height};
}

// `high`: of a row, pixels; draw_row(i, box) draws row i.
template <typename DrawRow>
void draw_table(const Ui& ui, const study::Texts& words, const char* name, const Box& box,
                std::span<const TableColumn> columns, float high, std::size_t rows,
                const DrawRow& draw_row) {
  const float head = ui.layout.size(34);
  const float gap = ui.layout.size(3);
  const Box room{box.x, box.y + head, box.width, box.height - head};
  const float all_high = high * static_cast<float>(rows);
  const Box titles{box.x, box.y, scrolled_width(room, all_high), head};
  for (const TableColumn& column : columns) {
    draw_line(ui.look.fonts.text, cell_of(titles, column), ui.look.palette.quiet,
              words(column.heading));
  }
  scrolled(name, room, all_high, [&](const Box& all) {
    for (std::size_t i = 0; i < rows; ++i) {
      draw_row(i, Box{all.x, all.y + high * static_cast<float>(i), all.width, high - gap});
    }
  });
}

}  // namespace promenade::app
