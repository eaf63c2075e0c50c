// [study] prereg: the document that was registered before the first session.
#include "study/identity.h"
#include "study/prereg_seal.h"
#include "study/study_parts.h"

namespace promenade::study {

void read_prereg_file(const TomlTable& root, std::string_view config_text, StudyFiles& files) {
  const TomlTable section = root.table("study").value_or(root.reader().empty());
  const std::string name = section.text("prereg").value_or("");
  if (name.empty()) return;
  try {
    const std::string& document = files.read(name);
    if (document.find(sha256_hex(without_seal(config_text))) != std::string::npos) return;
    section.warning("prereg", "\"" + name +
                                  "\" was not written for this study as it stands now; make it "
                                  "again with `promenade prereg`, or report the deviation");
  } catch (const InputError& error) {
    section.error("prereg", "cannot read the preregistration \"" + name +
                                "\": " + error.problems().front().message +
                                "; make it with `promenade prereg`");
  }
}

}  // namespace promenade::study
