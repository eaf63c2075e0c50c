#include "study/control.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>

#include "motion/problem.h"
#include "study/identity.h"
#include "study/utf8.h"

namespace promenade::study {
namespace {

using Json = nlohmann::json;

constexpr std::array<std::string_view, 7> known_words = {"pause", "resume",  "skip", "repeat",
                                                         "note",  "release", "stop"};
constexpr std::size_t longest_line = 16'384;   // bytes
constexpr std::size_t most_at_once = 65'536;   // bytes of one look
constexpr std::int64_t most_behind = 1 << 20;  // bytes: more was written by no hand

bool is_id(std::string_view text) {
  const auto fits = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-';
  };
  return !text.empty() && text.size() <= 64 && std::all_of(text.begin(), text.end(), fits);
}

std::string text_in(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : "";
}

int page_in(const Json& json) {
  const auto found = json.find("page");
  if (found == json.end() || !found->is_number_unsigned()) return -1;
  return static_cast<int>(std::min<std::uint64_t>(found->get<std::uint64_t>(), 1'000'000));
}

bool is_blank(std::string_view line) {
  return line.find_first_not_of(" \t\r") == std::string_view::npos;
}

bool same_file(const struct stat& a, const struct stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

// Must not be older than who reads it waits for; the clock may have been set back a little.
bool is_late(const Request& request, const std::string& now_utc) {
  const auto age_s = seconds_between(request.written_utc, now_utc);
  return !age_s || *age_s > oldest_request_s || *age_s < -oldest_request_s;
}

[[noreturn]] void refuse(const std::string& file) {
  throw OutsideError("cannot write " + file + " (" + std::strerror(errno) +
                     "): the session cannot be asked for anything");
}

}  // namespace

std::string requests_file(const std::string& database) { return database + ".control"; }

std::string line_of(const Request& request) {
  Json json = {{"id", request.id},
               {"session", request.session},
               {"do", request.what},
               {"written_utc", request.written_utc}};
  if (!request.words.empty()) json[request.what == "note" ? "text" : "reason"] = request.words;
  if (request.what == "repeat") json["block"] = request.block;
  if (request.page >= 0) json["page"] = request.page;
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::optional<Request> read_request(std::string_view line) {
  if (line.size() > longest_line) return std::nullopt;
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  Request request;
  request.id = text_in(json, "id");
  request.session = text_in(json, "session");
  request.what = text_in(json, "do");
  request.written_utc = text_in(json, "written_utc");
  if (!is_id(request.id) || !is_id(request.session) || request.what.empty()) return std::nullopt;
  const std::string words = text_in(json, request.what == "note" ? "text" : "reason");
  request.words = first_characters(words, most_request_characters);
  const bool known =
      std::find(known_words.begin(), known_words.end(), request.what) != known_words.end();
  if (!known) request.what = "unknown";
  const auto block = json.find("block");
  request.block = block != json.end() && block->is_boolean() && block->get<bool>();
  request.page = page_in(json);
  return request;
}

std::optional<decltype(Input::action)> action_of(const Request& request) {
  if (request.what == "pause") return Pause{};
  if (request.what == "resume") return Resume{};
  if (request.what == "release") return Release{};
  const bool silent = request.words.find_first_not_of(" \t\r\n") == std::string::npos;
  if (silent) return std::nullopt;
  if (request.what == "skip") return Skip{request.words};
  if (request.what == "repeat") return Repeat{request.block, request.words};
  if (request.what == "note") return Note{request.words};
  if (request.what == "stop") return Stop{request.words};
  return std::nullopt;
}

// Begins with the end of whatever line a writer that died has left behind.
void ask(const std::string& database, const Request& request) {
  struct stat state {};
  const mode_t rights = ::stat(database.c_str(), &state) == 0 ? state.st_mode & 0666U : 0600U;
  const std::string file = requests_file(database);
  constexpr int flags = O_WRONLY | O_APPEND | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW;
  int handle = ::open(file.c_str(), flags | O_CREAT | O_EXCL, 0600);
  if (handle >= 0) ::fchmod(handle, rights);
  if (handle < 0 && errno == EEXIST) handle = ::open(file.c_str(), flags);
  if (handle < 0) refuse(file);
  const std::string line = "\n" + line_of(request);
  const bool regular = ::fstat(handle, &state) == 0 && S_ISREG(state.st_mode);
  if (!regular) errno = EINVAL;
  const bool whole =
      regular && ::write(handle, line.data(), line.size()) == static_cast<ssize_t>(line.size());
  const int error = errno;
  ::close(handle);
  errno = error;
  if (!whole) refuse(file);
}

void remove_requests(const std::string& database) { ::unlink(requests_file(database).c_str()); }

RequestReader::RequestReader(const std::string& database) : file_(requests_file(database)) {
  if (!reopen()) return;
  offset_ = size_;
  char last = '\n';
  if (size_ > 0 && ::pread(handle_, &last, 1, size_ - 1) == 1) skips_ = last != '\n';
}

RequestReader::~RequestReader() {
  if (handle_ >= 0) ::close(handle_);
}

// What is no file is not opened: a pipe would wait, or take what another one was to read.
bool RequestReader::reopen() {
  struct stat there {};
  struct stat open {};
  const bool is_file = ::stat(file_.c_str(), &there) == 0 && S_ISREG(there.st_mode);
  size_ = is_file ? there.st_size : 0;
  const bool was_open = handle_ >= 0 && ::fstat(handle_, &open) == 0;
  if (is_file && was_open && same_file(there, open)) return true;
  if (handle_ >= 0) ::close(handle_);
  handle_ = -1;
  offset_ = 0;
  rest_.clear();
  skips_ = false;
  if (!is_file) return false;
  handle_ = ::open(file_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (handle_ < 0) return false;
  return ::fstat(handle_, &open) == 0 && S_ISREG(open.st_mode) && same_file(there, open);
}

bool RequestReader::waiting() { return reopen() && size_ != offset_; }

RequestReader::News RequestReader::take(const std::string& session, const std::string& now_utc) {
  News news;
  if (!waiting()) return news;
  if (size_ < offset_ || size_ - offset_ > most_behind) {
    const bool shorter = size_ < offset_;
    news.broken = !shorter && !had_broken_;
    offset_ = shorter ? 0 : size_;
    rest_.clear();
    skips_ = !shorter;
  }
  read(news, session, now_utc);
  had_broken_ = had_broken_ || news.broken;
  return news;
}

void RequestReader::read(News& news, const std::string& session, const std::string& now_utc) {
  const auto count =
      static_cast<std::size_t>(std::min<std::int64_t>(size_ - offset_, std::int64_t{most_at_once}));
  const std::size_t before = rest_.size();
  rest_.resize(before + count);
  const ssize_t got = ::pread(handle_, rest_.data() + before, count, offset_);
  rest_.resize(before + static_cast<std::size_t>(std::max<ssize_t>(0, got)));
  offset_ += std::max<ssize_t>(0, got);
  std::size_t from = 0;
  for (std::size_t end = rest_.find('\n'); end != std::string::npos; end = rest_.find('\n', from)) {
    if (!skips_) sort_in(std::string_view(rest_).substr(from, end - from), news, session, now_utc);
    skips_ = false;
    from = end + 1;
  }
  rest_.erase(0, from);
  if (rest_.size() <= longest_line) return;
  news.broken = news.broken || !had_broken_;
  rest_.clear();
  skips_ = true;
}

void RequestReader::sort_in(std::string_view line, News& news, const std::string& session,
                            const std::string& now_utc) {
  if (is_blank(line)) return;
  std::optional<Request> request = read_request(line);
  if (!request) {
    news.broken = news.broken || !had_broken_;
    return;
  }
  if (request->session != session || !seen_.insert(request->id).second) return;
  std::vector<Request>& where = is_late(*request, now_utc) ? news.late : news.asked;
  where.push_back(std::move(*request));
}

}  // namespace promenade::study
