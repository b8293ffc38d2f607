// SPDX-License-Identifier: MIT
// Finds the parameters of the coding of people and writes them as a header:
//
//   wire_train_models POSES OUTPUT      (tools/wire/train_models.sh makes both from the motion files)
//   wire_train_models POSES --left-out  (how well motion is coded that was not trained on)

#include "training.hpp"

#include <cstdio>
#include <cstring>

using namespace wire;

int main(int p_count, char **p_arguments) {
	if (p_count < 3) {
		std::fprintf(stderr, "expected: POSES OUTPUT, or POSES --left-out\n");
		return 2;
	}
	const std::vector<training::Clip> clips = training::read_clips(p_arguments[1]);
	if (clips.empty()) {
		std::fprintf(stderr, "%s: no poses\n", p_arguments[1]);
		return 1;
	}
	if (std::strcmp(p_arguments[2], "--left-out") == 0) {
		training::report_left_out(clips);
		return 0;
	}
	return training::write_models(training::train_all(clips), p_arguments[2]) ? 0 : 1;
}
