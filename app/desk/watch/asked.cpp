#include "app/desk/watch/asked.h"

#include <algorithm>

#include "study/identity.h"

namespace promenade::app {
namespace {

// By then the session would have refused it.
constexpr std::int64_t patience_us = 1'000'000 * (study::oldest_request_s + 3);

const study::WatchedSession* session_of(const study::Watched& now, const std::string& uuid) {
  const auto found = std::find_if(now.sessions.begin(), now.sessions.end(),
                                  [&](const auto& one) { return one.uuid == uuid; });
  return found == now.sessions.end() ? nullptr : &*found;
}

bool take_answer(Asked& asked, const study::WatchedSession& session) {
  for (const study::WatchedAnswer& answer : session.answers) {
    if (answer.request != asked.request.id) continue;
    asked.state = answer.done ? Asked::State::done : Asked::State::refused;
    asked.why = answer.why;
    return true;
  }
  return false;
}

void follow_one(Asked& asked, const study::Watched& now, std::int64_t now_us) {
  if (asked.state == Asked::State::done) return;
  const study::WatchedSession* session = session_of(now, asked.request.session);
  if (session != nullptr && take_answer(asked, *session)) return;
  if (asked.state != Asked::State::asked) return;
  if (session != nullptr && session->state == study::WatchedState::ended) {
    asked.state = Asked::State::refused;
    asked.why = "ended";
  } else if (now_us - asked.asked_us > patience_us) {
    asked.state = Asked::State::silent;
  }
}

}  // namespace

std::string asked_words(const study::Texts& texts, const Asked& asked) {
  static constexpr const char* keys[] = {"watch.is_asked", "watch.is_done", "watch.is_refused",
                                         "watch.is_silent"};
  const std::string* known = texts.find("watch.why_" + asked.why);
  return texts.with(keys[static_cast<std::size_t>(asked.state)],
                    {{"what", texts(std::string("watch.asked_") + asked.order->name)},
                     {"why", known != nullptr ? *known : asked.why},
                     {"code", asked.participant}});
}

void AskedList::ask(const Order& order, const study::WatchedSession& session,
                    const std::string& words, std::int64_t now_us) {
  study::Request request;
  request.id = study::random_uuid();
  request.session = session.uuid;
  request.what = order.what;
  request.words = words;
  request.block = order.block;
  if (order.is_about_page) request.page = session.page_index;
  request.written_utc = study::utc_now();
  study::ask(database_, request);
  Asked& asked = all_.emplace_back();
  asked.request = std::move(request);
  asked.order = &order;
  asked.participant = session.participant;
  asked.asked_us = now_us;
}

void AskedList::follow(const study::Watched& now, std::int64_t now_us) {
  for (Asked& one : all_) follow_one(one, now, now_us);
}

bool AskedList::waits() const {
  return std::any_of(all_.begin(), all_.end(),
                     [](const Asked& one) { return one.state == Asked::State::asked; });
}

}  // namespace promenade::app
