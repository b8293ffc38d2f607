// SPDX-License-Identifier: MIT
#include "motion_set.hpp"

#include <algorithm>
#include <cmath>

namespace matching {

namespace {

/// Directions that are told apart.
constexpr float SECTOR = PI / 4.0f;
/// Faster than this nobody is reversed, heights of the hips a second: a run backwards looks like none.
constexpr float FASTEST_REVERSED = 1.9f;
/// Who runs has a foot on the ground for less than half of a stride, with some doubt about contacts.
constexpr float RUNNING_SHARE = 0.4f;

bool goes_back(const MotionSet::Entry &p_entry) {
	return !p_entry.stands && std::fabs(p_entry.travel) > 0.625f * PI;
}

} // namespace

MotionSet::MotionSet(const std::vector<Clip> &p_recorded) {
	for (std::size_t i = 0; i < p_recorded.size(); i++) {
		if (!p_recorded[i].frames.empty()) {
			Clip level = p_recorded[i];
			level_feet(level);
			Clip twin = mirror(level);
			_add(std::move(level), int(i));
			_add(std::move(twin), int(i));
		}
	}
	if (std::none_of(_entries.begin(), _entries.end(), goes_back)) {
		const std::vector<Entry> forward = _entries;
		for (const Entry &entry : forward) {
			if (!entry.stands && entry.speed < FASTEST_REVERSED) {
				_add(reverse(entry.clip), entry.recorded);
			}
		}
	}
	_sort_into_families();
}

void MotionSet::_add(Clip p_clip, int p_recorded) {
	Entry entry;
	entry.recorded = p_recorded;
	float x = 0.0f;
	float z = 0.0f;
	float on_ground = 0.0f;
	for (const ClipFrame &frame : p_clip.frames) {
		x += frame.velocity_x;
		z += frame.velocity_z;
		for (std::size_t side = 0; side < 2; side++) {
			entry.rests[side] = entry.rests[side] + frame.pose.ankles[side];
			on_ground += ((frame.contacts >> side) & 1U) != 0 ? 0.5f : 0.0f;
		}
	}
	const float count = float(p_clip.frames.size());
	entry.speed = std::hypot(x, z) / count;
	entry.stands = entry.speed < STANDING_SPEED;
	entry.runs = !entry.stands && p_clip.stance == STAND && on_ground < RUNNING_SHARE * count;
	entry.travel = entry.stands ? 0.0f : std::atan2(x, z);
	for (Vec3 &rest : entry.rests) {
		rest = rest * (1.0f / count);
	}
	for (const ClipFrame &frame : p_clip.frames) {
		for (std::size_t side = 0; side < 2; side++) {
			entry.reach = std::max(entry.reach, std::fabs(frame.pose.ankles[side].z - entry.rests[side].z));
		}
	}
	entry.clip = std::move(p_clip);
	_entries.push_back(std::move(entry));
}

void MotionSet::_sort_into_families() {
	const auto sector = [](const Entry &p_entry) { return int(std::lround(p_entry.travel / SECTOR)) & 7; };
	const auto key = [&](const Entry &p_entry) {
		return int(p_entry.clip.stance) * 32 + (p_entry.stands ? 16 : 8 * int(p_entry.runs) + sector(p_entry));
	};
	std::stable_sort(
			_entries.begin(), _entries.end(), [&](const Entry &p_a, const Entry &p_b) { return key(p_a) < key(p_b); });
	std::vector<Features> rows;
	for (std::size_t i = 0; i < _entries.size(); i++) {
		Entry &entry = _entries[i];
		_features.push_back(features_of(entry.clip));
		if (i == 0 || key(entry) != key(_entries[i - 1])) {
			const int start = int(rows.size());
			const float travel = entry.stands ? 0.0f : wrapped(float(sector(entry)) * SECTOR);
			_families.push_back({ entry.clip.stance, entry.stands, entry.runs, travel, start, start });
		}
		entry.family = int(_families.size()) - 1;
		const int frames = int(entry.clip.frames.size());
		for (int frame = 0; frame < std::max(frames - LAST_FRAMES, 1); frame++) {
			rows.push_back(_features[i][std::size_t(frame)]);
			_places.push_back({ int(i), frame });
		}
		_families.back().end_row = int(rows.size());
	}
	_table.assign(rows);
}

int MotionSet::row_of(const Place &p_place) const {
	const auto found =
			std::lower_bound(_places.begin(), _places.end(), p_place, [](const Place &p_a, const Place &p_b) {
				return p_a.entry != p_b.entry ? p_a.entry < p_b.entry : p_a.frame < p_b.frame;
			});
	if (found != _places.end() && found->entry == p_place.entry) {
		return int(found - _places.begin());
	}
	return int(found - _places.begin()) - 1;
}

bool MotionSet::has(Stance p_stance) const {
	return std::any_of(
			_families.begin(), _families.end(), [&](const Family &p_family) { return p_family.stance == p_stance; });
}

bool MotionSet::has_gait(Stance p_stance, bool p_runs) const {
	return std::any_of(_families.begin(), _families.end(), [&](const Family &p_family) {
		return p_family.stance == p_stance && !p_family.stands && p_family.runs == p_runs;
	});
}

bool MotionSet::has(Stance p_stance, bool p_stands) const {
	return std::any_of(_families.begin(), _families.end(),
			[&](const Family &p_family) { return p_family.stance == p_stance && p_family.stands == p_stands; });
}

int MotionSet::frame_count() const {
	int count = 0;
	for (const Entry &entry : _entries) {
		count += int(entry.clip.frames.size());
	}
	return count;
}

const Features &MotionSet::features_at(const Place &p_place) const {
	return _features[std::size_t(p_place.entry)][std::size_t(p_place.frame)];
}

} // namespace matching
