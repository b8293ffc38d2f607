// SPDX-License-Identifier: MIT
#pragma once

#include <surroundings.hpp>

#include <godot_cpp/classes/physics_test_motion_parameters3d.hpp>
#include <godot_cpp/classes/physics_test_motion_result3d.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <array>
#include <unordered_map>

namespace godot {

/// The bodies of a physics space around a walker, whether the space makes steps or not.
class BodySurroundings : public mover::Surroundings {
public:
	BodySurroundings();
	~BodySurroundings() override;
	BodySurroundings(const BodySurroundings &) = delete;
	BodySurroundings &operator=(const BodySurroundings &) = delete;

	/// The space, what it belongs to, and the layers that stop a walker.
	void enter(const RID &p_space, const Ref<Resource> &p_world, std::uint32_t p_mask);
	/// A body that carries who stands on it, under a number from 1 on; 0: it does not any more.
	void set_carrier(const RID &p_body, std::uint32_t p_number);
	void set_ladder(const RID &p_body, bool p_is_ladder);
	/// Lets a walker pass through a body.
	void set_passable(const RID &p_body, bool p_is_passable);
	void clear();

	void sweep(mover::Stance p_stance, const mover::Vec3 &p_from, const mover::Vec3 &p_motion,
			mover::Sweep &r_sweep) const override;
	bool find_frame(std::uint32_t p_carrier, mover::Frame &r_frame) const override;

private:
	/// The space lasts as long as bodies are in it: the engine crashes where one outlives it.
	Ref<Resource> _world;
	std::array<RID, mover::STANCES> _bodies;
	std::array<RID, mover::STANCES> _shapes;
	Ref<PhysicsTestMotionParameters3D> _parameters;
	Ref<PhysicsTestMotionResult3D> _result;
	std::unordered_map<std::uint64_t, std::uint32_t> _numbers;
	std::unordered_map<std::uint32_t, RID> _carriers;
	std::unordered_map<std::uint64_t, bool> _ladders;
	TypedArray<RID> _passable;
};

} // namespace godot
