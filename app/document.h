// A short document of headings, paragraphs, lists and tables, as HTML or as Markdown. Text is
// escaped: nothing that a study says can become markup.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace promenade::app {

using Cells = std::vector<std::string>;

class Document {
 public:
  virtual ~Document() = default;
  virtual void heading(int level, std::string_view text) = 0;  // level from 1
  virtual void paragraph(std::string_view text) = 0;           // an empty line begins another
  virtual void list(const std::vector<std::string>& points) = 0;
  virtual void table(const Cells& columns, const std::vector<Cells>& rows) = 0;
  virtual void verbatim(std::string_view text) = 0;        // of a file, to the letter
  virtual std::string take(const std::string& title) = 0;  // the whole of it
};

class HtmlDocument : public Document {
 public:
  void heading(int level, std::string_view text) override;
  void paragraph(std::string_view text) override;
  void list(const std::vector<std::string>& points) override;
  void table(const Cells& columns, const std::vector<Cells>& rows) override;
  void verbatim(std::string_view text) override;
  std::string take(const std::string& title) override;

 private:
  std::string body_;
};

class MarkdownDocument : public Document {
 public:
  void heading(int level, std::string_view text) override;
  void paragraph(std::string_view text) override;
  void list(const std::vector<std::string>& points) override;
  void table(const Cells& columns, const std::vector<Cells>& rows) override;
  void verbatim(std::string_view text) override;
  std::string take(const std::string& title) override;

 private:
  std::string body_;
};

}  // namespace promenade::app
