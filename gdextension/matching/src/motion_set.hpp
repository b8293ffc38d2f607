// SPDX-License-Identifier: MIT
#pragma once

#include "feature_table.hpp"

#include <memory>
#include <vector>

namespace matching {

/// Clips to choose from: those that were recorded, their mirrored twins and, where nobody was recorded walking
/// backwards, slow ones reversed in time. Never changes after it was made, so that many matchers share it.
class MotionSet {
public:
	/// A clip in the set.
	struct Entry {
		Clip clip;
		int recorded = 0; ///< Index of the recorded clip that it was made from.
		int family = 0;
		float speed = 0.0f; ///< Mean, heights of the hips a second.
		float travel = 0.0f; ///< Angle from where the person faces to where he goes, rad.
		bool stands = false;
		bool runs = false; ///< Both feet are off the ground at times.
		std::array<Vec3, 2> rests{}; ///< Where the ankles are on average,
		float reach = 0.0f; ///< and how far from there they come along the way.
	};
	/// Clips of one stance that go in about one direction: neighbours in the table.
	struct Family {
		Stance stance = STAND;
		bool stands = false;
		bool runs = false;
		float travel = 0.0f; ///< As of an entry.
		int first_row = 0;
		int end_row = 0;
	};
	/// A frame of an entry.
	struct Place {
		int entry = -1;
		int frame = 0;
	};

	/// Slower than this somebody stands, heights of the hips a second.
	static constexpr float STANDING_SPEED = 0.25f;
	/// So many frames before a clip's end nothing begins any more.
	static constexpr int LAST_FRAMES = 15;

	explicit MotionSet(const std::vector<Clip> &p_recorded);

	const std::vector<Entry> &entries() const { return _entries; }
	const std::vector<Family> &families() const { return _families; }
	const FeatureTable &table() const { return _table; }
	/// The features of a frame, scaled; the nearest that the table has of its clip.
	int row_of(const Place &p_place) const;
	const Place &place_of(int p_row) const { return _places[std::size_t(p_row)]; }
	bool has(Stance p_stance) const;
	/// Whether there is somebody who stands, or goes, in a stance.
	bool has(Stance p_stance, bool p_stands) const;
	/// Whether there is somebody who runs, or walks, in a stance.
	bool has_gait(Stance p_stance, bool p_runs) const;
	/// Number of frames, with those that were made.
	int frame_count() const;
	/// The features of a frame, not scaled.
	const Features &features_at(const Place &p_place) const;

private:
	void _add(Clip p_clip, int p_recorded);
	void _sort_into_families();

	std::vector<Entry> _entries;
	std::vector<Family> _families;
	std::vector<std::vector<Features>> _features;
	std::vector<Place> _places;
	FeatureTable _table;
};

} // namespace matching
