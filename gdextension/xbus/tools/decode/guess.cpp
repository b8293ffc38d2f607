// SPDX-License-Identifier: MIT
#include "formats.hpp"

#include "device/full_judge.hpp"

#include <algorithm>
#include <cmath>

using namespace xbus;

namespace {

/// Messages that a guess must make sense of.
constexpr std::size_t MAX_TRIED = 50;
constexpr std::size_t MAX_TRACKERS = 20;
/// Messages that may be missing before another.
constexpr uint16_t MAX_MISSED = 100;
/// Quaternions and matrices of real devices are nearer to a rotation than this.
constexpr double MAX_DEVIATION = 1.0e-3;

constexpr std::array<uint16_t, 10> MODES = { output_mode::ORIENTATION, output_mode::CALIBRATED,
	output_mode::CALIBRATED | output_mode::ORIENTATION, output_mode::TEMPERATURE | output_mode::ORIENTATION,
	output_mode::TEMPERATURE | output_mode::CALIBRATED,
	output_mode::TEMPERATURE | output_mode::CALIBRATED | output_mode::ORIENTATION,
	output_mode::ORIENTATION | output_mode::STATUS,
	output_mode::CALIBRATED | output_mode::ORIENTATION | output_mode::STATUS,
	output_mode::ORIENTATION | output_mode::AUXILIARY, output_mode::CALIBRATED | output_mode::STATUS };

bool is_sample_sensible(const FullSample &p_sample) {
	if (!is_in_range(p_sample)) {
		return false;
	}
	if (p_sample.has(Field::QUATERNION) && !(norm_deviation(p_sample.quaternion) < MAX_DEVIATION)) {
		return false;
	}
	if (p_sample.has(Field::MATRIX) && !(rotation_deviation(p_sample.matrix) < MAX_DEVIATION)) {
		return false;
	}
	if (p_sample.has(Field::ACCELERATION)) {
		const Sample::Vector &a = p_sample.acceleration;
		const double strength = std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
		// Free fall and a hard blow are rare.
		return strength > 0.5 && strength < 100.0;
	}
	return true;
}

/// How hard it is to fit by accident: to be of length 1 harder than to weigh about as much as gravity, and that
/// harder than to be an angle.
int evidence_of(const OutputFormat &p_format) {
	const uint32_t form = p_format.settings & output_setting::ORIENTATION_MASK;
	if ((p_format.mode & output_mode::ORIENTATION) != 0 && form != output_setting::EULER) {
		return 2;
	}
	return (p_format.mode & output_mode::CALIBRATED) != 0 ? 1 : 0;
}

/// Whether the message decodes into samples that make sense.
bool is_sensible(const DataFormat &p_format, const Frame &p_frame, std::vector<FullSample> &r_samples) {
	return decode_frame(p_format, p_frame, r_samples) &&
			std::all_of(r_samples.begin(), r_samples.end(), is_sample_sensible);
}

/// Whether nearly all messages make sense: on a bad line some are wrong.
bool fits(const DataFormat &p_format, const std::vector<Frame> &p_frames) {
	std::vector<FullSample> samples;
	const std::size_t tried = std::min(p_frames.size(), MAX_TRIED);
	const std::size_t most_wrong = tried / 10;
	std::size_t wrong = 0;
	std::size_t astray = 0;
	uint32_t last = 0;
	for (std::size_t i = 0; i < tried; i++) {
		wrong += is_sensible(p_format, p_frames[i], samples) ? 0U : 1U;
		if (wrong > most_wrong || samples.empty()) {
			return false;
		}
		astray += i == 0 || uint16_t(samples[0].counter - last - 1U) < MAX_MISSED ? 0U : 1U;
		last = samples[0].counter;
	}
	const bool counts = p_format.is_master || samples[0].has(Field::COUNTER);
	return !counts || astray <= most_wrong;
}

/// All formats of this size that devices are set to in practice.
std::vector<DataFormat> candidates(std::size_t p_size) {
	std::vector<DataFormat> found;
	found.reserve(16);
	for (const uint16_t mode : MODES) {
		for (uint32_t bits = 0; bits < 24; bits++) {
			const uint32_t form = bits % 3 << 2U;
			if (form != 0 && (mode & output_mode::ORIENTATION) == 0) {
				continue;
			}
			DataFormat format;
			format.source = "guess";
			format.tracker = { mode, (bits / 3 % 4) << output_setting::NUMBER_SHIFT | form | bits / 12 };
			if (format.tracker.size() == p_size) {
				found.push_back(format);
			}
			const std::size_t block = format.tracker.size_behind_master();
			if (bits < 12 && p_size > MasterFormat::HEAD && (p_size - MasterFormat::HEAD) % block == 0 &&
					(p_size - MasterFormat::HEAD) / block <= MAX_TRACKERS) {
				format.is_master = true;
				for (std::size_t i = 0; i < (p_size - MasterFormat::HEAD) / block; i++) {
					format.trackers.add(format.tracker);
				}
				found.push_back(format);
			}
		}
	}
	return found;
}

} // namespace

std::optional<DataFormat> guess_format(const std::vector<Frame> &p_frames, std::size_t p_trackers) {
	std::optional<DataFormat> found;
	if (p_frames.empty()) {
		return found;
	}
	int best = -1;
	for (const DataFormat &format : candidates(p_frames[0].size)) {
		const int evidence = evidence_of(format.tracker);
		const bool right_number = p_trackers == 0 || (format.is_master && format.trackers.count() == p_trackers);
		if (evidence < best || !right_number || !fits(format, p_frames)) {
			continue;
		}
		// Two that are as good as each other: no guess, unless there is a better one.
		found = evidence > best ? std::optional<DataFormat>(format) : std::nullopt;
		best = evidence;
	}
	return found;
}
