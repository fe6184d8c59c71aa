// SPDX-License-Identifier: MIT
// What settled the article's questions: bench_article QUESTION measures one, bench_article all of them.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <string>

#include "article/questions.h"

namespace firma::bench {
namespace {

struct Question {
    const char* name;
    int (*measure)(const Settings&);
    const char* purpose;
};

constexpr Question kQuestions[] = {
    {"formulas", &measure_formulas,
     "The article's formulas against exact answers. An argument names a folder for hits that score.py can read."},
    {"inside", &measure_inside, "Inside a polygon or not: what ways of telling cost and what they let through."},
    {"boxes", &measure_boxes, "Culling faces by their boxes, three ways."},
    {"edges", &measure_edges, "Edges and vertices: culled or not, shared ones once or each time."},
    {"tree", &measure_tree, "Casts with and without a tree, and under each stop rule."},
    {"subdivision", &measure_subdivision, "Casting against binary subdivision: cost and tunnelling."},
    {"stop_distance", &measure_stop_distance, "The distance kept from a wall at any speed; the skin is 1 mm."}};

std::string all_purposes() {
    std::string text = "The article's questions; the first argument names one of them:\n";
    for (const Question& question : kQuestions)
        text.append("\n  ").append(question.name).append(": ").append(question.purpose);
    return text;
}

int measure_all(int argc, char** argv) {
    const Settings settings = read_settings(argc, argv, all_purposes().c_str());
    if (!settings.rest.empty()) {
        std::fprintf(stderr, "%s: the question comes first\n", argv[0]);
        return 2;
    }
    int worst = 0;
    for (const Question& question : kQuestions) worst = std::max(worst, question.measure(settings));
    return worst;
}

int run(int argc, char** argv) {
    if (argc < 2 || argv[1][0] == '-') return measure_all(argc, argv);
    for (const Question& question : kQuestions) {
        if (std::strcmp(argv[1], question.name) != 0) continue;
        std::string program = std::string(argv[0]).append(" ").append(question.name);
        argv[1] = program.data();
        return question.measure(read_settings(argc - 1, argv + 1, question.purpose));
    }
    std::fprintf(stderr, "%s: %s is none of its questions. Try --help\n", argv[0], argv[1]);
    return 2;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    return firma::bench::run(argc, argv);
}
