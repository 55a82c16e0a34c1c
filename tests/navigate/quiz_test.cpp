// Quizzes: what counts as right, and marks that spreadsheets and programs read.

#include "engine/navigate/quiz.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace odontoscope::test {
namespace {

LessonQuestion click() {
  return {.kind = LessonQuestion::Kind::click, .ask = "Click it", .structure = "pulp", .part = "distal canal"};
}
LessonQuestion choice() {
  return {.kind = LessonQuestion::Kind::choice,
          .ask = "Which, \"this\"?",
          .choices = {"enamel", "dentine", "pulp"},
          .answer = 1};
}
LessonQuestion number() {
  return {.kind = LessonQuestion::Kind::number, .ask = "How long?", .answer = 12.5, .within = 0.1, .unit = "mm"};
}

TEST(Quiz, KnowsWhatIsRight) {
  EXPECT_TRUE(is_right(click(), PointedAt{"pulp", "distal canal"}));
  EXPECT_FALSE(is_right(click(), PointedAt{"pulp", "mesial canal"}));
  EXPECT_FALSE(is_right(click(), PointedAt{"dentine", "distal canal"}));
  LessonQuestion chamber = click();
  chamber.part = "chamber";
  EXPECT_TRUE(is_right(chamber, PointedAt{"Pulp", "pulp chamber"}));
  LessonQuestion whole = click();
  whole.part.clear();
  EXPECT_TRUE(is_right(whole, PointedAt{"pulp", "mesial canal"}));
  EXPECT_TRUE(is_right(choice(), std::size_t{1}));
  EXPECT_FALSE(is_right(choice(), std::size_t{2}));
  EXPECT_TRUE(is_right(number(), 12.6)) << "0.1 is no double";
  EXPECT_TRUE(is_right(number(), 12.4));
  EXPECT_FALSE(is_right(number(), 12.61));
  LessonQuestion counted = number();
  counted.within = 0;
  EXPECT_TRUE(is_right(counted, 12.5));
  EXPECT_FALSE(is_right(counted, 12.4999));
}

TEST(Quiz, ReadsNumbersAsPeopleWriteThem) {
  EXPECT_EQ(number_from("12.5"), 12.5);
  EXPECT_EQ(number_from(" 12,5 "), 12.5);
  EXPECT_EQ(number_from("+3"), 3);
  for (const char* none : {"", " ", "three", "12.5 mm", "1,2,3", "nan", "inf", "1e999", "++3"})
    EXPECT_FALSE(number_from(none)) << none;
}

TEST(Quiz, TellsTheRightAnswerInWords) {
  EXPECT_EQ(right_answer(click()), "distal canal");
  EXPECT_EQ(right_answer(choice()), "dentine");
  EXPECT_EQ(right_answer(number()), "12.5 mm");
}

Quiz some_quiz() {
  Lesson lesson{"Find your way", "", {}};
  lesson.notes.resize(4);
  lesson.notes[0].question = click();
  lesson.notes[2].question = choice();
  lesson.notes[3].question = number();
  return quiz_of(lesson);
}

TEST(Quiz, CountsEachQuestionOnce) {
  Quiz quiz = some_quiz();
  ASSERT_EQ(quiz.rows.size(), 3u);
  EXPECT_EQ(quiz.row_of(1), nullptr);
  EXPECT_EQ(quiz.score(), 0u);
  for (const std::size_t note : {0, 2, 3}) {
    EXPECT_FALSE(quiz.finished());
    quiz.row_of(note)->answered = quiz.row_of(note)->right = true;
  }
  EXPECT_TRUE(quiz.finished());
  EXPECT_EQ(quiz.score(), 3u);
}

TEST(Quiz, MarksAreWrittenForSpreadsheetsAndPrograms) {
  Quiz quiz = some_quiz();
  quiz.rows[0] = {0, LessonQuestion::Kind::click, "=1+1", "distal canal", true, true, 4.24};
  quiz.rows[2].given = "-3 mm";
  EXPECT_EQ(marks_csv(quiz),
            "number,kind,question,given,right,seconds\n"
            "1,click,'=1+1,distal canal,yes,4.2\n"
            "2,choice,\"Which, \"\"this\"\"?\",,no,0.0\n"
            "3,number,How long?,-3 mm,no,0.0\n");
  const auto json = nlohmann::json::parse(marks_json(quiz));
  EXPECT_EQ(json["format"], "odontoscope.marks");
  EXPECT_EQ(json["version"], 1);
  EXPECT_EQ(json["title"], "Find your way");
  EXPECT_EQ(json["score"], 1);
  EXPECT_EQ(json["of"], 3);
  EXPECT_EQ(json["rows"][0]["question"], "=1+1");
  EXPECT_EQ(json["rows"][0]["right"], true);
  EXPECT_EQ(json["rows"][0]["seconds"], 4.2);
  EXPECT_EQ(json["rows"][2]["kind"], "number");
}

}  // namespace
}  // namespace odontoscope::test
