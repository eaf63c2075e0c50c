#include "app/second_copy.h"

#include <chrono>
#include <exception>
#include <system_error>
#include <utility>

namespace promenade::app {
namespace {

std::optional<std::string> guarded(const SecondCopy::Work& work) noexcept {
  try {
    return work();
  } catch (const std::exception& error) {
    return std::string("no second copy of the session: ") + error.what();
  } catch (...) {
    return "no second copy of the session";
  }
}

}  // namespace

void SecondCopy::start(Work work) {
  started_ = true;
  try {
    running_ = std::async(std::launch::async, [work] { return guarded(work); });
  } catch (const std::system_error&) {
    problem_ = guarded(work);
  }
}

std::optional<std::string> SecondCopy::problem() {
  const bool ready =
      running_.valid() && running_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  if (ready) problem_ = running_.get();
  return problem_;
}

void SecondCopy::finish() {
  if (running_.valid()) running_.wait();
}

}  // namespace promenade::app
