// SPDX-License-Identifier: MIT
#pragma once

#include "motion_set.hpp"

namespace matching {

/// Plays a set: chooses the moment of it that fits, and goes on from there. Everything in heights of the hips.
class Player {
public:
	/// What is played now.
	struct Sample {
		Pose pose;
		float velocity_x = 0.0f; ///< Of the clip, in the frame of the person's way.
		float velocity_z = 0.0f;
		std::array<bool, 2> stands{}; ///< Which feet stand.
	};

	/// Begins with somebody who stands, where the set has one.
	void reset(const MotionSet &p_set);
	/// Goes on in another set, from somebody who moves as given, by that set's moment that fits best.
	void enter(const MotionSet &p_set, const Features &p_current, const Way &p_way, Stance p_stance, bool p_runs);
	/// Looks for a better moment of somebody who runs, or does not. Returns whether another one is played now.
	bool search(const MotionSet &p_set, const Way &p_way, Stance p_stance, bool p_runs);
	/// Goes on; faster or slower by a rate. Returns false at the end of a clip: a search is due.
	bool advance(const MotionSet &p_set, float p_delta, float p_rate);
	Sample sample(const MotionSet &p_set, float p_ahead_s = 0.0f) const;
	const MotionSet::Entry &entry(const MotionSet &p_set) const { return p_set.entries()[std::size_t(_entry)]; }
	int entry_index() const { return _entry; }
	float frame() const { return _frame; }

private:
	/// The moment of a set that fits best to somebody who moves as given; r_own_cost is of going on as now.
	FeatureTable::Found _nearest(const MotionSet &p_set, const Features &p_current, const Way &p_way, Stance p_stance,
			bool p_runs, float &r_own_cost) const;
	void _go_to(const MotionSet::Place &p_place);
	float _clamped(const MotionSet &p_set, float p_frame) const;

	int _entry = 0;
	float _frame = 0.0f;
	float _direction = 1.0f; ///< Who stands is played to and fro.
};

} // namespace matching
