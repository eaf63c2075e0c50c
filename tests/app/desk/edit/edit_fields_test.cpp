#include "app/desk/edit/edit_fields.h"

#include <gtest/gtest.h>

#include "app/desk/edit/edit_form.h"
#include "app/desk/words.h"
#include "app/registry.h"
#include "study/toml_text.h"

namespace promenade::app {
namespace {

std::vector<EditField> all_fields() {
  std::vector<EditField> fields;
  for (const EditSection& section : edit_sections()) {
    fields.insert(fields.end(), section.fields.begin(), section.fields.end());
  }
  for (const std::string& name : edit_item_names()) {
    const std::vector<EditField>& items = edit_items(name);
    fields.insert(fields.end(), items.begin(), items.end());
  }
  return fields;
}

TEST(EditFields, HaveALabelAndASentenceInEveryLanguage) {
  for (const std::string& language : desk_languages()) {
    const study::Texts words = desk_texts(language);
    for (const EditField& field : all_fields()) {
      for (const char* part : {".label", ".help"}) {
        EXPECT_NE(words.find("edit." + field.words + part), nullptr) << field.words << part;
      }
    }
    for (const EditSection& section : edit_sections()) {
      EXPECT_NE(words.find("edit.section." + section.name), nullptr) << section.name;
    }
    for (const std::string& name : edit_item_names()) {
      EXPECT_NE(words.find("edit.add." + name), nullptr) << name;
    }
  }
}

TEST(EditFields, NameListsOfItemsThatThereAre) {
  const std::vector<std::string> names = edit_item_names();
  for (const EditField& field : all_fields()) {
    if (field.kind != FieldKind::list) continue;
    EXPECT_NE(std::find(names.begin(), names.end(), field.choices), names.end()) << field.key;
  }
}

TEST(EditFields, TakeTheParametersOfEveryInterface) {
  for (const study::InterfaceType& type : interfaces().all()) {
    const std::vector<EditField> fields = parameter_fields(interfaces(), type.name);
    ASSERT_EQ(fields.size(), type.parameters.size());
    for (const EditField& field : fields) EXPECT_FALSE(field.own_help.empty()) << field.key;
  }
}

TEST(EditFields, ShowWhatTheKindOfATaskNeedsAndWhatTheFileHas) {
  using study::toml_text;
  const EditField& limit = edit_items("task")[11];
  ASSERT_EQ(limit.key, "threshold");
  EXPECT_TRUE(is_shown(limit, study::toml_table({{"kind", toml_text("match")}})));
  EXPECT_FALSE(is_shown(limit, study::toml_table({{"kind", toml_text("find")}})));
  EXPECT_TRUE(is_shown(
      limit, study::toml_table({{"kind", toml_text("find")}, {"threshold", toml_text("auto")}})));
}

TEST(EditFields, SayWhatTheyTakeInEveryLanguage) {
  const EditField people{.key = "people", .kind = FieldKind::whole, .least = 1, .most = 500};
  for (const std::string& language : desk_languages()) {
    const std::string words = EditForm::refusal_of(people, desk_texts(language));
    EXPECT_NE(words.find("500"), std::string::npos) << words;
    EXPECT_EQ(words.find('{'), std::string::npos) << words;
  }
}

}  // namespace
}  // namespace promenade::app
