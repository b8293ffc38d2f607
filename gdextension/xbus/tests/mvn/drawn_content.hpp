// SPDX-License-Identifier: MIT
#pragma once

// Samples of every type as MVN could send them, drawn at random.

#include "mvn/encoder.hpp"

#include <cmath>
#include <random>

namespace drawn {

using namespace mvn;

constexpr std::array<Type, 12> TYPES_OF_ALL = { Type::EULER_POSE, Type::POSE, Type::POINTS, Type::UNITY_POSE,
	Type::META, Type::SCALE, Type::JOINT_ANGLES, Type::LINEAR_KINEMATICS, Type::ANGULAR_KINEMATICS, Type::TRACKERS,
	Type::CENTRE_OF_MASS, Type::TIME_CODE };

class Source {
public:
	explicit Source(unsigned p_seed) : _random(p_seed) {}

	unsigned below(unsigned p_end) { return std::uniform_int_distribution<unsigned>(0, p_end - 1)(_random); }
	float real() { return std::uniform_real_distribution<float>(-3.0F, 3.0F)(_random); }
	Vector vector() { return { real(), real(), real() }; }
	Quaternion rotation() {
		Quaternion found{};
		float norm = 0.0F;
		do {
			norm = 0.0F;
			for (float &part : found) {
				part = real();
				norm += part * part;
			}
		} while (norm < 0.01F);
		for (float &part : found) {
			part /= std::sqrt(norm);
		}
		return found;
	}

	SegmentMotion motion(int p_id, Type p_type, bool p_is_full) {
		SegmentMotion found;
		found.id = p_id;
		if (p_type == Type::LINEAR_KINEMATICS) {
			found.position = vector();
			found.velocity = vector();
			found.acceleration = vector();
			return found;
		}
		found.rotation = rotation();
		if (p_type == Type::ANGULAR_KINEMATICS) {
			found.angular_velocity = vector();
			found.angular_acceleration = vector();
			return found;
		}
		found.free_acceleration = vector();
		found.magnetic_field = vector();
		found.is_full = p_is_full;
		if (p_is_full) {
			found.acceleration = vector();
			found.rate = vector();
		}
		return found;
	}

	/// A sample; its segments are a body's, with props and fingers if asked for.
	Content content(Type p_type, uint32_t p_sample, bool p_has_fingers = false) {
		Content found;
		Header &header = found.header;
		header.type = p_type;
		header.sample = p_sample;
		header.time_code_ms = p_sample * 10;
		header.body_segments = BODY_SEGMENTS;
		header.props = p_has_fingers ? MAX_PROPS : 0;
		header.fingers = p_has_fingers ? FINGER_SEGMENTS : 0;
		const int segments = header.body_segments + header.props + header.fingers;
		const bool is_full = below(2) == 0;
		for (int segment = 0; segment < segments; ++segment) {
			fill_segment(found, segment, is_full);
		}
		found.centre_of_mass = p_type == Type::CENTRE_OF_MASS ? vector() : Vector{};
		if (p_type == Type::META) {
			found.tags = { { "name", "Jörg " + std::to_string(below(9)) }, { "xmid", "17" }, { "color", "FF8000" },
				{ "unheard-of", "a:b" } };
		} else if (p_type == Type::TIME_CODE) {
			found.time_code = "12:34:56.78" + std::to_string(below(10));
		}
		return found;
	}

private:
	void fill_segment(Content &r_content, int p_segment, bool p_is_full) {
		switch (r_content.header.type) {
			case Type::EULER_POSE:
				r_content.poses.push_back({ p_segment + 1, vector(), {}, vector() });
				r_content.poses.back().rotation = { 1.0F, 0.0F, 0.0F, 0.0F };
				break;
			case Type::POSE:
			case Type::UNITY_POSE:
				r_content.poses.push_back({ p_segment + 1, vector(), rotation(), {} });
				break;
			case Type::POINTS:
				r_content.poses.push_back({ (p_segment + 1) * 256 + 1, vector(), {}, {}, false });
				r_content.poses.back().rotation = { 1.0F, 0.0F, 0.0F, 0.0F };
				break;
			case Type::SCALE:
				r_content.origins.push_back({ "Segment " + std::to_string(p_segment), vector() });
				for (uint16_t point = 1; point < 4; ++point) {
					r_content.points.push_back({ uint16_t(p_segment + 1), point, "pPoint", below(8), vector() });
				}
				break;
			case Type::JOINT_ANGLES:
				r_content.joints.push_back({ (p_segment + 1) * 256, (p_segment + 2) * 256, vector() });
				break;
			case Type::LINEAR_KINEMATICS:
			case Type::ANGULAR_KINEMATICS:
			case Type::TRACKERS:
				r_content.motions.push_back(motion(p_segment + 1, r_content.header.type, p_is_full));
				break;
			default:
				break;
		}
	}

	std::mt19937 _random;
};

inline bool same(const SegmentPose &p_a, const SegmentPose &p_b) {
	return p_a.id == p_b.id && p_a.position == p_b.position && p_a.rotation == p_b.rotation && p_a.euler == p_b.euler &&
			p_a.has_rotation == p_b.has_rotation;
}
inline bool same(const JointAngle &p_a, const JointAngle &p_b) {
	return p_a.parent_point == p_b.parent_point && p_a.child_point == p_b.child_point && p_a.angles == p_b.angles;
}
inline bool same(const SegmentMotion &p_a, const SegmentMotion &p_b) {
	return p_a.id == p_b.id && p_a.position == p_b.position && p_a.velocity == p_b.velocity &&
			p_a.acceleration == p_b.acceleration && p_a.rotation == p_b.rotation &&
			p_a.angular_velocity == p_b.angular_velocity && p_a.angular_acceleration == p_b.angular_acceleration &&
			p_a.free_acceleration == p_b.free_acceleration && p_a.rate == p_b.rate &&
			p_a.magnetic_field == p_b.magnetic_field && p_a.is_full == p_b.is_full &&
			p_a.has_rotation == p_b.has_rotation;
}
inline bool same(const SegmentOrigin &p_a, const SegmentOrigin &p_b) {
	return p_a.name == p_b.name && p_a.origin == p_b.origin;
}
inline bool same(const BodyPoint &p_a, const BodyPoint &p_b) {
	return p_a.segment == p_b.segment && p_a.point == p_b.point && p_a.name == p_b.name && p_a.flags == p_b.flags &&
			p_a.position == p_b.position;
}
template <class Item>
bool same(const std::vector<Item> &p_a, const std::vector<Item> &p_b) {
	bool fits = p_a.size() == p_b.size();
	for (std::size_t at = 0; fits && at < p_a.size(); ++at) {
		fits = same(p_a[at], p_b[at]);
	}
	return fits;
}
/// Whether two samples hold the same; heads but for their parts and sizes.
inline bool same(const Content &p_a, const Content &p_b) {
	const Header &a = p_a.header;
	const Header &b = p_b.header;
	return a.type == b.type && a.sample == b.sample && a.time_code_ms == b.time_code_ms && a.character == b.character &&
			same(p_a.poses, p_b.poses) && same(p_a.joints, p_b.joints) && same(p_a.motions, p_b.motions) &&
			same(p_a.origins, p_b.origins) && same(p_a.points, p_b.points) && p_a.tags == p_b.tags &&
			p_a.centre_of_mass == p_b.centre_of_mass && p_a.time_code == p_b.time_code;
}

} // namespace drawn
