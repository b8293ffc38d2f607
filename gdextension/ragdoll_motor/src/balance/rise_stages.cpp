// SPDX-License-Identifier: MIT
#include "balance/rise_stages.hpp"

namespace ragdoll {

namespace {

// The poses were found by hand on films of stick people, times and torques by hand and some 100 tries of a random
// search, by bench ground, scene rise; none was swept alone. Angles are in degrees here.

constexpr float DEGREES = PI / 180.0f;

using Pair = std::array<float, 2>;

JointAngles sides(float p_pitch, const Pair &p_thigh, const Pair &p_knee, const Pair &p_arm, const Pair &p_arm_out,
		const Pair &p_elbow, const Pair &p_wrist) {
	const auto turned = [](const Pair &p_pair) { return Pair{ p_pair[0] * DEGREES, p_pair[1] * DEGREES }; };
	JointAngles angles;
	angles.pitch = p_pitch * DEGREES;
	angles.thigh = turned(p_thigh);
	angles.knee = turned(p_knee);
	angles.arm = turned(p_arm);
	angles.arm_out = turned(p_arm_out);
	angles.elbow = turned(p_elbow);
	angles.wrist = turned(p_wrist);
	return angles;
}

/// Both sides alike.
JointAngles both(float p_pitch, float p_spine, float p_neck, float p_thigh, float p_thigh_out, float p_knee,
		float p_ankle, float p_arm, float p_arm_out, float p_elbow, float p_wrist) {
	const auto twice = [](float p_angle) { return Pair{ p_angle, p_angle }; };
	JointAngles angles = sides(
			p_pitch, twice(p_thigh), twice(p_knee), twice(p_arm), twice(p_arm_out), twice(p_elbow), twice(p_wrist));
	angles.spine = p_spine * DEGREES;
	angles.neck = p_neck * DEGREES;
	angles.thigh_out = twice(p_thigh_out * DEGREES);
	angles.ankle = twice(p_ankle * DEGREES);
	return angles;
}

/// @param p_within degrees, 0 for anybody
RiseStage stage(RisePart p_part, float p_blend_s, float p_most_s, float p_within, float p_torque, float p_lean,
		bool p_only_rolls, const JointAngles &p_pose) {
	return { p_part, p_blend_s, p_most_s, p_within * DEGREES, p_torque, p_lean, p_only_rolls, p_pose };
}

RiseStage straighten(float p_lean) {
	return stage(RisePart::RISING, 0.7f, 0.7f, 0.0f, 150.0f, p_lean, false, JointAngles());
}

/// Curls up, sits up, draws the feet in, comes over them off the hands behind.
std::vector<RiseStage> face_up() {
	return {
		stage(RisePart::TUCKING, 0.25f, 0.3f, 0.0f, 60.0f, 0.0f, true,
				both(-80.0f, 40.0f, -40.0f, 5.0f, 10.0f, 10.0f, 0.0f, -20.0f, 20.0f, 60.0f, -60.0f)),
		stage(RisePart::ROLLING, 0.3f, 0.55f, 60.0f, 90.0f, 0.0f, false,
				both(-10.0f, 50.0f, -34.0f, 110.0f, 10.0f, 20.0f, 18.0f, -20.0f, 15.0f, 10.0f, -80.0f)),
		stage(RisePart::ROLLING, 0.3f, 0.3f, 0.0f, 60.0f, 0.0f, false,
				both(20.0f, 30.0f, 0.0f, 145.0f, 10.0f, 150.0f, -10.0f, -10.0f, 20.0f, 0.0f, -80.0f)),
		stage(RisePart::ROLLING, 0.4f, 0.85f, 55.0f, 220.0f, 0.1f, false,
				both(35.0f, 24.0f, 0.0f, 136.0f, 15.0f, 138.0f, 30.0f, 9.0f, 11.0f, 0.0f, -60.0f)),
		straighten(0.41f),
	};
}

/// Hands come beside the shoulders and push; hands and knees; over the feet off the hands ahead.
std::vector<RiseStage> face_down() {
	return {
		stage(RisePart::TUCKING, 0.25f, 0.3f, 0.0f, 60.0f, 0.0f, true,
				both(90.0f, -10.0f, 20.0f, 20.0f, 15.0f, 40.0f, -17.0f, 10.0f, 85.0f, 60.0f, 60.0f)),
		stage(RisePart::ROLLING, 0.21f, 0.35f, 0.0f, 60.0f, 0.0f, true,
				both(75.0f, -10.0f, 30.0f, 60.0f, 10.0f, 80.0f, 10.0f, 60.0f, 40.0f, 90.0f, 80.0f)),
		stage(RisePart::ROLLING, 0.3f, 0.45f, 60.0f, 60.0f, 0.0f, true,
				both(70.0f, 0.0f, 30.0f, 95.0f, 10.0f, 95.0f, 20.0f, 100.0f, 10.0f, 5.0f, 80.0f)),
		stage(RisePart::ROLLING, 0.4f, 0.65f, 45.0f, 110.0f, 0.0f, false,
				both(45.0f, 20.0f, 10.0f, 130.0f, 15.0f, 130.0f, 35.0f, 110.0f, 5.0f, 0.0f, 60.0f)),
		straighten(0.24f),
	};
}

/// Over the stretched arm below onto the face.
std::vector<RiseStage> left_side() {
	return {
		stage(RisePart::TUCKING, 0.25f, 0.45f, 45.0f, 100.0f, 0.0f, false,
				sides(90.0f, { 5.0f, 20.0f }, { 10.0f, 20.0f }, { 150.0f, 50.0f }, { 0.0f, 0.0f }, { 10.0f, 60.0f },
						{ 0.0f, 60.0f })),
	};
}

/// Onto the back.
std::vector<RiseStage> left_back() {
	return {
		stage(RisePart::TUCKING, 0.25f, 0.45f, 45.0f, 100.0f, 0.0f, false,
				sides(-90.0f, { 5.0f, 20.0f }, { 10.0f, 20.0f }, { 20.0f, 6.0f }, { 30.0f, 40.0f }, { 11.0f, 51.0f },
						{ 0.0f, 0.0f })),
	};
}

/// Down onto the hands, then as who lies face down.
std::vector<RiseStage> kneels() {
	return {
		stage(RisePart::ROLLING, 0.25f, 0.35f, 60.0f, 60.0f, 0.0f, false,
				both(70.0f, 0.0f, 30.0f, 95.0f, 10.0f, 95.0f, 20.0f, 100.0f, 10.0f, 5.0f, 80.0f)),
		stage(RisePart::ROLLING, 0.35f, 0.5f, 45.0f, 110.0f, 0.0f, false,
				both(45.0f, 23.0f, 10.0f, 130.0f, 15.0f, 130.0f, 35.0f, 113.0f, 5.0f, 0.0f, 57.0f)),
		straighten(0.8f),
	};
}

std::vector<RiseStage> mirrored(std::vector<RiseStage> p_stages) {
	for (RiseStage &one : p_stages) {
		one.pose = one.pose.mirrored();
	}
	return p_stages;
}

} // namespace

const std::vector<RiseStage> &get_stages(Lie p_lie) {
	static const std::array<std::vector<RiseStage>, LIE_COUNT> all = { face_up(), face_down(), left_side(),
		mirrored(left_side()), left_back(), mirrored(left_back()), kneels() };
	return all[std::size_t(p_lie)];
}

} // namespace ragdoll
