// SPDX-License-Identifier: MIT
#include "motion_set.hpp"

#include <convert.hpp>
#include <motion_file.hpp>

#include <godot_cpp/classes/file_access.hpp>

#include <chrono>
#include <cmath>

namespace godot {

namespace {

constexpr int64_t MAX_MEASURED = 1000000;

String from_text(const std::string &p_text) {
	return String::utf8(p_text.c_str(), int64_t(p_text.size()));
}

} // namespace

String MotionSet::load_file(const String &p_path) {
	if (!FileAccess::file_exists(p_path)) {
		return "there is no motion set " + p_path;
	}
	const String fault = load_bytes(FileAccess::get_file_as_bytes(p_path));
	return fault.is_empty() ? fault : p_path + String(": ") + fault;
}

String MotionSet::load_bytes(const PackedByteArray &p_bytes) {
	std::vector<matching::Clip> clips;
	const std::string fault = matching::read_motion_file(p_bytes.ptr(), std::size_t(p_bytes.size()), clips);
	if (!fault.empty()) {
		return from_text(fault);
	}
	_clips = std::move(clips);
	_core = std::make_shared<const matching::MotionSet>(_clips);
	return "";
}

PackedByteArray MotionSet::to_bytes() const {
	const std::vector<uint8_t> bytes = matching::write_motion_file(_clips);
	PackedByteArray result;
	result.resize(int64_t(bytes.size()));
	std::copy(bytes.begin(), bytes.end(), result.ptrw());
	return result;
}

void MotionSet::begin_body(
		const PackedVector3Array &p_hip_joints, double p_thigh, double p_shank, double p_ankle_height, double p_foot) {
	ERR_FAIL_COND_MSG(p_hip_joints.size() != 2, "There is a hip joint for each of two legs.");
	for (const double length : { p_thigh, p_shank, p_ankle_height, p_foot }) {
		ERR_FAIL_COND_MSG(!(length > 0.0 && length < 3.0), "A length of a body is above 0 and below 3 m.");
	}
	_body.thigh = float(p_thigh);
	_body.shank = float(p_shank);
	_body.ankle_height = float(p_ankle_height);
	_body.foot = float(p_foot);
	ERR_FAIL_COND_MSG(
			!p_hip_joints[0].is_finite() || !p_hip_joints[1].is_finite(), "A hip joint is at a finite place.");
	_body.hip_joints = { to_core(p_hip_joints[0]), to_core(p_hip_joints[1]) };
	_body.measure();
}

String MotionSet::add_clip(const String &p_name, int64_t p_stance, const PackedVector3Array &p_hips,
		const PackedFloat32Array &p_orientations, int64_t p_first, int64_t p_end) {
	const int64_t floats = 4 * int64_t(matching::LIMBS);
	if (p_orientations.size() != p_hips.size() * floats) {
		return "a clip has 64 numbers of rotations for each place of the hips";
	}
	if (p_stance < 0 || p_stance >= matching::STANCES || p_first < 0 || p_end > p_hips.size() || p_end < p_first + 2) {
		return "a clip has a stance from 0 to 4 and at least two frames";
	}
	std::vector<matching::RawFrame> frames(std::size_t(p_hips.size()), matching::RawFrame());
	const float *numbers = p_orientations.ptr();
	for (std::size_t i = 0; i < frames.size(); i++) {
		frames[i].hips = to_core(p_hips[int64_t(i)]);
		bool is_sound = frames[i].hips.is_finite();
		for (kinematics::Quat &limb : frames[i].limbs) {
			limb = { numbers[0], numbers[1], numbers[2], numbers[3] };
			numbers += 4;
			is_sound = is_sound && limb.dot(limb) > 0.8f && limb.dot(limb) < 1.2f;
		}
		if (!is_sound) {
			return "frame " + String::num_int64(int64_t(i)) + " is no pose";
		}
	}
	matching::Clip clip = matching::build_clip(frames, std::size_t(p_first), std::size_t(p_end), _body);
	clip.name = p_name.utf8().get_data();
	clip.stance = matching::Stance(p_stance);
	_clips.push_back(std::move(clip));
	_core = nullptr;
	return "";
}

String MotionSet::add_clip_of(const Ref<MotionSet> &p_other, int64_t p_clip) {
	const matching::Clip *clip = p_other.is_valid() ? p_other->_clip(p_clip) : nullptr;
	if (clip == nullptr) {
		return "there is no clip " + String::num_int64(p_clip) + " in that set";
	}
	// The other set can be this one, whose clips move when there are more.
	const matching::Clip same = *clip;
	_clips.push_back(same);
	_core = nullptr;
	return "";
}

const matching::Clip *MotionSet::_clip(int64_t p_clip) const {
	return p_clip >= 0 && p_clip < int64_t(_clips.size()) ? &_clips[std::size_t(p_clip)] : nullptr;
}

const matching::MotionSet::Entry *MotionSet::_entry_of(int64_t p_clip) const {
	if (_core == nullptr) {
		return nullptr;
	}
	for (const matching::MotionSet::Entry &entry : _core->entries()) {
		if (entry.recorded == p_clip && _clip(p_clip) != nullptr && entry.clip.name == _clip(p_clip)->name) {
			return &entry;
		}
	}
	return nullptr;
}

int64_t MotionSet::get_clip_count() const {
	return int64_t(_clips.size());
}

String MotionSet::get_clip_name(int64_t p_clip) const {
	return _clip(p_clip) != nullptr ? from_text(_clip(p_clip)->name) : String();
}

int64_t MotionSet::get_clip_stance(int64_t p_clip) const {
	return _clip(p_clip) != nullptr ? int64_t(_clip(p_clip)->stance) : 0;
}

int64_t MotionSet::get_clip_frame_count(int64_t p_clip) const {
	return _clip(p_clip) != nullptr ? int64_t(_clip(p_clip)->frames.size()) : 0;
}

double MotionSet::get_clip_speed(int64_t p_clip) const {
	return _entry_of(p_clip) != nullptr ? double(_entry_of(p_clip)->speed) : 0.0;
}

double MotionSet::get_clip_travel(int64_t p_clip) const {
	return _entry_of(p_clip) != nullptr ? double(_entry_of(p_clip)->travel) : 0.0;
}

double MotionSet::get_clip_contact_share(int64_t p_clip) const {
	const matching::Clip *clip = _clip(p_clip);
	if (clip == nullptr || clip->frames.empty()) {
		return 0.0;
	}
	int stands = 0;
	for (const matching::ClipFrame &frame : clip->frames) {
		stands += (frame.contacts & 1U) + ((frame.contacts >> 1U) & 1U);
	}
	return stands / (2.0 * double(clip->frames.size()));
}

int64_t MotionSet::get_frame_count() const {
	return _core != nullptr ? _core->frame_count() : 0;
}

int64_t MotionSet::get_searched_count() const {
	return _core != nullptr ? _core->table().size() : 0;
}

int64_t MotionSet::measure_search(int64_t p_searches, int64_t p_seed, int64_t p_least_rows) const {
	ERR_FAIL_COND_V_MSG(_core == nullptr, -1, "There is nothing to search in.");
	ERR_FAIL_COND_V_MSG(p_searches < 1 || p_searches > MAX_MEASURED || p_least_rows < 1 || p_least_rows > MAX_MEASURED,
			-1, "There are 1 to 1,000,000 searches in as many rows.");
	std::vector<matching::Features> rows;
	uint32_t state = uint32_t(p_seed) * 2U + 1U;
	const auto draw = [&]() {
		state = state * 1664525U + 1013904223U;
		return float(state >> 8U) / 16777216.0f - 0.5f;
	};
	while (int64_t(rows.size()) < p_least_rows) {
		for (std::size_t i = 0; i < _core->entries().size(); i++) {
			const int count = int(_core->entries()[i].clip.frames.size());
			for (int frame = 0; frame < count && int64_t(rows.size()) < p_least_rows; frame++) {
				matching::Features row = _core->features_at({ int(i), frame });
				for (std::size_t k = 0; k < matching::FEATURES; k++) {
					row[k] += 0.05f * draw();
				}
				rows.push_back(row);
			}
		}
	}
	matching::FeatureTable table;
	table.assign(rows);
	std::vector<matching::Features> wanted;
	for (int64_t i = 0; i < p_searches; i++) {
		matching::Features row = rows[std::size_t((draw() + 0.5f) * float(rows.size() - 1))];
		for (std::size_t k = 0; k < matching::ANKLES; k++) {
			row[k] += 0.6f * draw();
		}
		table.scale(row);
		wanted.push_back(row);
	}
	int64_t sum = 0;
	const auto begin = std::chrono::steady_clock::now();
	for (const matching::Features &row : wanted) {
		sum += table.nearest(row, 0, table.size(), std::numeric_limits<float>::max()).row;
	}
	const auto taken = std::chrono::steady_clock::now() - begin;
	return sum < 0 ? -1 : std::chrono::duration_cast<std::chrono::nanoseconds>(taken).count() / p_searches;
}

void MotionSet::_bind_methods() {
	ClassDB::bind_method(D_METHOD("load_file", "path"), &MotionSet::load_file);
	ClassDB::bind_method(D_METHOD("load_bytes", "bytes"), &MotionSet::load_bytes);
	ClassDB::bind_method(D_METHOD("to_bytes"), &MotionSet::to_bytes);
	ClassDB::bind_method(
			D_METHOD("begin_body", "hip_joints", "thigh", "shank", "ankle_height", "foot"), &MotionSet::begin_body);
	ClassDB::bind_method(
			D_METHOD("add_clip", "name", "stance", "hips", "orientations", "first", "end"), &MotionSet::add_clip);
	ClassDB::bind_method(D_METHOD("add_clip_of", "other", "clip"), &MotionSet::add_clip_of);
	ClassDB::bind_method(D_METHOD("get_clip_count"), &MotionSet::get_clip_count);
	ClassDB::bind_method(D_METHOD("get_clip_name", "clip"), &MotionSet::get_clip_name);
	ClassDB::bind_method(D_METHOD("get_clip_stance", "clip"), &MotionSet::get_clip_stance);
	ClassDB::bind_method(D_METHOD("get_clip_frame_count", "clip"), &MotionSet::get_clip_frame_count);
	ClassDB::bind_method(D_METHOD("get_clip_speed", "clip"), &MotionSet::get_clip_speed);
	ClassDB::bind_method(D_METHOD("get_clip_travel", "clip"), &MotionSet::get_clip_travel);
	ClassDB::bind_method(D_METHOD("get_clip_contact_share", "clip"), &MotionSet::get_clip_contact_share);
	ClassDB::bind_method(D_METHOD("get_frame_count"), &MotionSet::get_frame_count);
	ClassDB::bind_method(D_METHOD("get_searched_count"), &MotionSet::get_searched_count);
	ClassDB::bind_method(D_METHOD("measure_search", "searches", "seed", "least_rows"), &MotionSet::measure_search);
}

} // namespace godot
