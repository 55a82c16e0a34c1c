// The lessons that come with the program: whole, readable, and true of the sample molar that they are about.

#include "engine/navigate/built_in_lessons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

#include "recon/sample/sample_tooth.h"

namespace odontoscope::test {
namespace {

std::vector<Lesson> all() {
  std::vector<Lesson> tours;
  for (std::size_t number = 0; number < built_in_lessons().size(); ++number) tours.push_back(built_in_lesson(number));
  return tours;
}

TEST(BuiltInLessons, AreListedInTheirOrder) {
  std::vector<std::string> titles;
  for (const BuiltInLesson& lesson : built_in_lessons()) titles.push_back(lesson.title);
  EXPECT_EQ(titles, (std::vector<std::string>{"The tooth and its tissues", "Down the three canals", "Canal types",
                                              "What a radiograph hides", "Find your way"}));
  EXPECT_GE(built_in_lessons().back().questions, 8u);
  EXPECT_LE(built_in_lessons().back().questions, 12u);
}

TEST(BuiltInLessons, CanBeReadAtAGlance) {
  constexpr std::size_t most_bytes = 420;  // what fits on the card beside the tooth
  for (const Lesson& lesson : all()) {
    EXPECT_EQ(lesson.language, "en");
    for (const LessonNote& note : lesson.notes) {
      EXPECT_FALSE(note.title.empty()) << lesson.title;
      EXPECT_LE(note.text.size(), most_bytes) << note.title;
      EXPECT_TRUE(!note.text.empty() || note.question) << note.title;
      if (note.question) {
        EXPECT_FALSE(note.question->explain.empty()) << note.title;
      }
    }
  }
}

TEST(BuiltInLessons, AskInAllThreeWays) {
  for (const auto kind : {LessonQuestion::Kind::click, LessonQuestion::Kind::choice, LessonQuestion::Kind::number}) {
    const Lesson quiz = all().back();
    EXPECT_GE(std::count_if(quiz.notes.begin(), quiz.notes.end(),
                            [&](const LessonNote& note) { return note.question && note.question->kind == kind; }),
              2);
  }
}

/// Whatever they name is there, by that name; and what they say of it in numbers is so.
TEST(BuiltInLessons, SpeakOfTheSampleMolar) {
  const SampleFacts facts = sample_facts(ToothKind::molar);
  std::vector<std::string> parts = {"pulp chamber"};
  for (const CanalFact& canal : facts.canals) parts.push_back(canal.name + " canal");
  const std::vector<std::string> structures = {"enamel", "dentine", "pulp"};
  std::set<std::string> arrow_labels;
  const auto among = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const Lesson& lesson : all())
    for (const LessonNote& note : lesson.notes) {
      if (!note.tour.empty()) {
        EXPECT_TRUE(among(parts, note.tour)) << note.tour;
      }
      for (const LessonArrow& arrow : note.arrows) {
        EXPECT_LE(std::max(std::abs(arrow.to.x), std::abs(arrow.to.y)), 6) << arrow.label;
        EXPECT_TRUE(arrow.to.z > 0 && arrow.to.z < 22) << arrow.label;
        arrow_labels.insert(arrow.label);
        if (arrow.label == "orifice") {
          EXPECT_TRUE(std::any_of(facts.canals.begin(), facts.canals.end(), [&](const CanalFact& canal) {
            return std::any_of(canal.axis.begin(), canal.axis.end(), [&](const Point3& at) {
              return canal.high_z - at.z < 1.5 && glm::distance(arrow.to, {at.x, at.y, at.z}) < 0.6;  // half a mouth
            });
          })) << note.title;
        }
      }
      for (const LessonPin& mark : note.marks) {
        EXPECT_LE(std::max(std::abs(mark.at.x), std::abs(mark.at.y)), 6) << mark.label;
        EXPECT_TRUE(mark.at.z > 0 && mark.at.z < 22) << mark.label;
      }
      if (!note.question || note.question->kind != LessonQuestion::Kind::click) continue;
      EXPECT_TRUE(among(structures, note.question->structure)) << note.title;
      if (!note.question->part.empty()) {
        EXPECT_TRUE(among(parts, note.question->part)) << note.title;
      }
    }
  EXPECT_TRUE(arrow_labels.contains("orifice") && arrow_labels.contains("furcation"));
  const Lesson quiz = all().back();
  const auto answer_of = [&](const char* title) {
    const auto found =
        std::find_if(quiz.notes.begin(), quiz.notes.end(), [&](const LessonNote& note) { return note.title == title; });
    return found == quiz.notes.end() ? -1 : found->question->answer;
  };
  EXPECT_EQ(answer_of("How many?"), static_cast<double>(facts.canals.size()));
  EXPECT_EQ(answer_of("Horns"), static_cast<double>(facts.horns.size()));
}

}  // namespace
}  // namespace odontoscope::test
