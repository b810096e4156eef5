// What main.cpp calls in the process that is asked to judge: see Grader in tool.hpp.

#include "rubric/rubric.hpp"

int judgeInstead(const char* evidence, bool many) {
  return ggrade::rubric::serveJudge(evidence, many);
}
