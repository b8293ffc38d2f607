// SPDX-License-Identifier: MIT
#pragma once

#include "gait/travel.hpp"

namespace ragdoll {

/// Travel for inertial suits: which points stand is judged by their height *and* by whether the velocity
/// that they imply for the body agrees with its momentum. A swinging toe clears the ground by 1 to 3 cm,
/// less than a foot model's error, so height alone misleads; its velocity does not.
///
/// All is done for the centre of mass, which nothing but the ground can accelerate. In flight it falls
/// freely. Points that stand are anchored, so that they do not skate. Starts best from standing.
class InertialGait : public Travel {
public:
	struct Settings {
		float cutoff = 16.0f; ///< Of the second-order low-pass by which points are judged, Hz.
		float clearance = 0.02f; ///< Height above the ground that counts 1, m.
		float contradiction = 0.4f; ///< Difference to the expected velocity that counts 1, m/s.
		float persistence = 1.0f; ///< What a limb that stood a sixtieth of a second before gains.
		float sharpness = 0.7f; ///< Temperature of the choice between the points.
		float air = 12.0f; ///< What it costs to stand on nothing.
		float follow_s = 0.047f; ///< How fast the horizontal velocity follows the points', s.
		float follow_up_s = 0.024f; ///< The same of the vertical one, s.
		float takeoff = 0.85f; ///< Upward speed from which a jump is possible, m/s.
		float takeoff_gap = 0.008f; ///< And height above the ground that the ballistic path has in 1/60 s, m.
		float step_up = 0.06f; ///< Ground that would lift the body by more above its path is not stood on, m.
		float settle_s = 0.2f; ///< For so long after a landing it is, s.
		float hold_s = 0.01f; ///< How fast a standing point is pulled back to its anchor, s.
		float hold_from = 0.5f; ///< Share of the surest point's weight from which a point is anchored.
		float release_below = 0.1f; ///< And below which it is let go.
	};

	explicit InertialGait(std::vector<ContactPoint> p_points);

	Settings settings;

	void shift(const Vec3 &p_offset) override;
	bool is_anchored(std::size_t p_point) const override { return _locks[p_point] != 0; }
	void save(ArchiveWriter &p_archive) const override;
	bool restore(ArchiveReader &p_archive) override;

protected:
	void begin(const GaitInput &p_input) override;
	void advance(const GaitInput &p_input) override;

private:
	/// A second-order Butterworth low-pass of one point.
	struct Filter {
		Vec3 input[2]; // Newest first.
		Vec3 output[2];
	};

	void filter(const GaitInput &p_input);
	/// Heights of the body over each point, were it on the ground; returns the highest admissible, m.
	float find_support(const GaitInput &p_input);
	bool is_falling(const GaitInput &p_input, float p_height);
	void weigh(float p_height, float p_delta_s);
	void walk(const GaitInput &p_input, float p_height);
	void fly(const GaitInput &p_input);
	void hold(const GaitInput &p_input);
	void finish(const GaitInput &p_input);

	std::vector<Filter> _filters;
	std::vector<Vec3> _smooth; // Points from the centre of mass, filtered, m.
	std::vector<Vec3> _footing; // The same as they are, for heights, m.
	std::vector<Vec3> _implied; // Velocity of the centre of mass if a point stands still, m/s.
	std::vector<float> _heights; // Of the centre of mass if a point touches, m.
	std::vector<float> _costs;
	std::vector<std::uint8_t> _locks; // Whether a point is anchored.
	Vec3 _centre; // Of mass, in the world, m.
	Vec3 _drift; // Its velocity, m/s.
	float _flown_s = 1.0f; // Since the last flight, s.
	float _standing = 0.0f; // Sum of the weights.
};

} // namespace ragdoll
