// SPDX-License-Identifier: MIT
#pragma once

#include "gait/takeoff.hpp"
#include "gait/travel.hpp"

namespace ragdoll {

/// Travel for inertial suits: which points stand is judged by their height *and* by whether the velocity
/// that they imply for the body agrees with its momentum. A swinging toe clears the ground by 1 to 3 cm,
/// less than a foot model's error, so height alone misleads; its velocity does not.
///
/// All is done for the centre of mass, which nothing but the ground can accelerate. Heights are judged
/// twice: over the world's ground and over the floor that the wearer's own pose stands on. A wearer who
/// walks on a level floor while his body walks down a slope has his lowest foot in the pose, not in the
/// world. In flight the centre falls freely, until a point is down or what carries the body is felt.
class InertialGait : public Travel {
public:
	/// The wearer's momentum and the points' errors, in the units of what they are compared with. Their
	/// source is a sweep of `bench gait --root=inertial` (walks, stairs, the three clips), each by itself,
	/// at half and twice its value. What holds there: walkers stay within 4 % of the way and their standing
	/// feet below 3 cm/s (with noise 8, or 1.15 of what they had), stairs end on the right tread, clips are
	/// off by at most a quarter more, and no flight is lost or invented.
	///
	/// Holds at half and at twice the value: clearance, persistence, sharpness, air, unknown, wander, lost,
	/// scatter, follow_up_s, adapt, adapt_s, drop, hold_s, release_below. Holds at half only: cutoff (8 to
	/// 16; with 22 feet skate with 3.1 cm/s), hold_from (0.25 to 0.5; 1 skates with 3.4). Sharp:
	/// contradiction (0.4 to 0.56 and 0.2; 0.28 skates with 3.3 cm/s, 0.8 loses 8 % of the way downstairs).
	struct Settings {
		float cutoff = 16.0f; ///< Of the second-order low-pass by which points are judged, Hz.
		float clearance = 0.02f; ///< Height above the ground that counts 1, m.
		float contradiction = 0.4f; ///< Difference to the expected velocity that counts 1, m/s.
		float persistence = 1.0f; ///< What a limb that stood a sixtieth of a second before gains.
		float sharpness = 0.7f; ///< Temperature of the choice between the points.
		float air = 6.0f; ///< What it costs to stand on nothing.
		float unknown = 2.0f; ///< Standard deviation of the velocity of who begins, m/s.
		float wander = 0.8f; ///< Growth of the velocity's variance, m^2/s^3.
		float lost = 2.0f; ///< The same where nothing stands and yet nothing flies, m^2/s^3.
		float misfit = 4.0f; ///< Mean cost of the best explanation from which the velocity is not believed any more.
		float misfit_s = 0.3f; ///< Over which that is averaged, s: longer than a stride's flight.
		float scatter = 0.4f; ///< Standard deviation of what standing points say of it, m/s.
		float follow_up_s = 0.024f; ///< How fast the vertical velocity follows the points', s.
		float adapt = 0.6f; ///< Speed at which the height follows ground that the pose knows nothing of, m/s.
		float adapt_s = 0.1f; ///< Or, if that is faster, the time in which it does, s.
		float drop = 0.3f; ///< Ground that is so much lower all at once is fallen to, m.
		float hold_s = 0.01f; ///< How fast a standing point is pulled back to its anchor, s.
		float hold_from = 0.5f; ///< Share of the surest point's weight from which a point is anchored.
		float release_below = 0.1f; ///< And below which it is let go.
	};

	explicit InertialGait(std::vector<ContactPoint> p_points);

	Settings settings;
	Takeoff takeoff;

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
	/// Velocity of a contact point at a place while it stands: that of the ground, and that of a ball's
	/// middle while the ball rolls, m/s.
	Vec3 slip(const GaitInput &p_input, std::size_t p_point, const Vec3 &p_at) const;
	/// Heights of the body over each point, were it on the ground; returns the highest, m.
	float find_support(const GaitInput &p_input);
	/// The same for a body that begins: its limbs may have been put into the ground, so that ground is looked for
	/// further and further above them.
	float find_first_support(const GaitInput &p_input);
	/// How fast the slowest of the pose's lowest points moves over the ground, m/s.
	float find_slide() const;
	void weigh(const GaitInput &p_input, float p_highest);
	float cost_of(std::size_t p_point, float p_expected, float p_persistence) const;
	/// Height of the centre by the points that stand, m.
	float find_standing_height() const;
	void walk(const GaitInput &p_input);
	void climb(float p_rising, float p_lifted, float p_delta_s);
	void hold(const GaitInput &p_input);
	void fly(const GaitInput &p_input, float p_height);
	void finish();

	std::vector<Filter> _filters;
	std::vector<Vec3> _smooth; // Points from the centre of mass, filtered, m.
	std::vector<Vec3> _footing; // The same as they are, for heights, m.
	std::vector<Vec3> _implied; // Velocity of the centre of mass if a point stands still, m/s.
	std::vector<float> _heights; // Of the centre of mass if a point touches, m.
	std::vector<float> _costs;
	std::vector<std::uint8_t> _locks; // Whether a point is anchored.
	Vec3 _centre; // Of mass, in the world, m.
	Vec3 _drift; // Its velocity, m/s.
	float _lift = 0.0f; // How fast the ground itself rises, m/s.
	float _doubt = 0.0f; // Variance of each horizontal component, m^2/s^2.
	float _misfit = 0.0f; // Mean cost of the best explanation.
	float _tall = 0.0f; // Height of the centre over the pose's lowest point, m.
	float _standing = 0.0f; // Sum of the weights.
};

} // namespace ragdoll
