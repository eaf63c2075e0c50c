#include "study/instrument.h"

#include <cmath>

namespace promenade::study {

bool allows(const Item& item, const ItemAnswer& answer) {
  if (item.kind != ItemKind::scale) return true;
  return answer.value && *answer.value >= item.least && *answer.value <= item.most &&
         *answer.value == std::round(*answer.value);
}

}  // namespace promenade::study
