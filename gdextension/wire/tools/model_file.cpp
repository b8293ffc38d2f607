// SPDX-License-Identifier: MIT
#include "training.hpp"

#include <cstdio>

namespace training {

using namespace wire;

namespace {

void write_numbers(std::FILE *p_file, const int16_t *p_numbers, int p_count) {
	std::fprintf(p_file, "{");
	for (int i = 0; i < p_count; i++) {
		std::fprintf(p_file, "%s%d", i > 0 ? ", " : " ", p_numbers[i]);
	}
	std::fprintf(p_file, " }");
}

void write_motion(std::FILE *p_file, const MotionModel &p_model) {
	std::fprintf(p_file, "{ ");
	write_numbers(p_file, p_model.gains, GAIN_STEPS);
	std::fprintf(p_file, ", ");
	write_numbers(p_file, p_model.biases, LIMB_CLASSES);
	std::fprintf(p_file, ", ");
	write_numbers(p_file, &p_model.part_biases[0][0], 3 * LIMB_CLASSES);
	std::fprintf(p_file, ", ");
	write_numbers(p_file, &p_model.pulls[0][0], 3 * LIMB_CLASSES);
	std::fprintf(p_file, ", ");
	write_numbers(p_file, p_model.passes, LIMB_CLASSES);
	std::fprintf(p_file, ", %d, %d, %d, %d, %d, %d, ", p_model.speed, p_model.part_speed, p_model.parent,
			p_model.average, p_model.part, p_model.along);
	write_numbers(p_file, p_model.shapes, 3);
	std::fprintf(p_file, " }");
}

void write_model(std::FILE *p_file, const PersonModel &p_model) {
	std::fprintf(p_file, "\t{ ");
	write_motion(p_file, p_model.root);
	std::fprintf(p_file, ",\n\t\t");
	write_motion(p_file, p_model.rotation);
	std::fprintf(p_file, " },\n");
}

void write_set(std::FILE *p_file, const char *p_name, const PersonModel (*p_models)[AGE_STEPS]) {
	std::fprintf(p_file, "constexpr PersonModel %s[2][AGE_STEPS] = {\n", p_name);
	for (int precision = 0; precision < 2; precision++) {
		std::fprintf(p_file, "\t{\n");
		for (int i = 0; i < AGE_STEPS; i++) {
			write_model(p_file, p_models[precision][i]);
		}
		std::fprintf(p_file, "\t},\n");
	}
	std::fprintf(p_file, "};\n");
}

void write_shares(std::FILE *p_file, const Models &p_models) {
	std::fprintf(p_file, "constexpr uint16_t SHARES_WITHIN[SHAPES][SHARE_POINTS] = {\n");
	for (const auto &shares : p_models.shares) {
		std::fprintf(p_file, "\t{");
		for (int i = 0; i < SHARE_POINTS; i++) {
			std::fprintf(p_file, "%s%d,", i % 16 == 0 ? "\n\t\t" : " ", shares[i]);
		}
		std::fprintf(p_file, "\n\t},\n");
	}
	std::fprintf(p_file, "};\n");
}

} // namespace

bool write_models(const Models &p_models, const char *p_path) {
	std::FILE *file = std::fopen(p_path, "wb");
	if (file == nullptr) {
		std::fprintf(stderr, "cannot write %s\n", p_path);
		return false;
	}
	std::fprintf(file,
			"// SPDX-License-Identifier: MIT\n#pragma once\n\n// Made by tools/wire/train_models.sh from the motion "
			"files in assets/motion: do not edit.\n// clang-format off\n\n#include "
			"\"coding/fixed_tables.hpp\"\n#include "
			"\"coding/person_model.hpp\"\n\nnamespace wire {\n\n");
	write_shares(file, p_models);
	std::fprintf(file, "/// Where there is no base.\nconstexpr PersonModel WHOLE_MODELS[2] = {\n");
	write_model(file, p_models.whole[0]);
	write_model(file, p_models.whole[1]);
	std::fprintf(file, "};\n/// With a base alone, by precision and age.\n");
	write_set(file, "STILL_MODELS", p_models.still);
	std::fprintf(file, "/// With a state before the base.\n");
	write_set(file, "MOVING_MODELS", p_models.moving);
	std::fprintf(file, "\n} // namespace wire\n");
	return std::fclose(file) == 0;
}

} // namespace training
