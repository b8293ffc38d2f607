// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// What the engine told Jolt in some ticks, as jolt_recording.gd wrote it: 32-bit floats, in the
/// order of the members here.
struct Recording {
	static constexpr std::size_t JOINT_TARGETS = 4;

	struct Place {
		float position[3];
		float rotation[4]; ///< x y z w
	};

	struct Settings {
		float velocity_steps;
		float position_steps;
		float baumgarte;
		float speculative_contact_distance;
		float penetration_slop;
		float linear_cast_threshold;
		float linear_cast_max_penetration;
		float body_pair_distance;
		float body_pair_angle;
		float bounce_velocity;
		float max_linear_velocity;
		float max_angular_velocity;
		float margin_fraction;
		float gravity;
	};

	struct Body {
		float mass;
		float inertia[3];
		float friction;
		float is_capsule;
		float size[3]; ///< Half of a box's edges; radius and half of the height of a capsule's cylinder.
		Place shape;
		Place place;
	};

	struct Joint {
		float parent; ///< Place of the body among those of the person; -1 for the world.
		Place frame_a;
		Place frame_b;
		float force;
	};

	std::size_t people = 0;
	std::size_t limbs = 0;
	std::size_t ticks = 0;
	float hz = 0.0f;
	Settings settings{};
	std::vector<Body> bodies;
	std::vector<Joint> joints;
	/// A tick: for each joint 3 angular velocities and the torque limit, then for each person 3 linear
	/// velocities.
	std::vector<float> targets;
	std::vector<Place> ends;

	/// How many numbers of targets a tick has.
	std::size_t tick_size() const { return people * (limbs * JOINT_TARGETS + 3); }

	/// Reads a file. Returns what is wrong, or an empty text.
	std::string read(const std::string &p_path);
};
