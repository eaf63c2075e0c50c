#include "app/desk/watch/chosen_session.h"

#include <algorithm>

namespace promenade::app {
namespace {

bool is_open(const study::WatchedSession& session) {
  return session.state != study::WatchedState::ended;
}

}  // namespace

bool any_is_open(const study::Watched& now) {
  return std::any_of(now.sessions.begin(), now.sessions.end(), is_open);
}

const study::WatchedSession* ChosenSession::in(const study::Watched& now) const {
  const auto found =
      std::find_if(now.sessions.begin(), now.sessions.end(),
                   [this](const auto& one) { return one.uuid == uuid_ && is_open(one); });
  return found == now.sessions.end() ? nullptr : &*found;
}

void ChosenSession::follow(const study::Watched& now) {
  const auto count = std::count_if(now.sessions.begin(), now.sessions.end(), is_open);
  if (count == 0) by_itself_ = true;
  if (in(now) != nullptr) return;
  if (!uuid_.empty() && count > 0) by_itself_ = false;
  uuid_.clear();
  if (count != 1 || !by_itself_) return;
  uuid_ = std::find_if(now.sessions.begin(), now.sessions.end(), is_open)->uuid;
}

}  // namespace promenade::app
