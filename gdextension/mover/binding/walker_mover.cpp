// SPDX-License-Identifier: MIT
#include "walker_mover.hpp"

#include <convert.hpp>

#include <algorithm>

namespace godot {

namespace {

constexpr std::size_t BYTES = mover::State::WORDS * sizeof(std::uint32_t);

} // namespace

void WalkerMover::enter(const RID &p_space, const Ref<Resource> &p_world, int64_t p_mask) {
	_surroundings.enter(p_space, p_world, std::uint32_t(p_mask));
}

void WalkerMover::set_carrier(const RID &p_body, int64_t p_number) {
	ERR_FAIL_COND_MSG(p_number < 0 || p_number > 65535, "A carrier's number is from 1 to 65535; 0 for none.");
	_surroundings.set_carrier(p_body, std::uint32_t(p_number));
}

void WalkerMover::set_ladder(const RID &p_body, bool p_is_ladder) {
	_surroundings.set_ladder(p_body, p_is_ladder);
}

void WalkerMover::set_passable(const RID &p_body, bool p_is_passable) {
	_surroundings.set_passable(p_body, p_is_passable);
}

void WalkerMover::clear_bodies() {
	_surroundings.clear();
}

void WalkerMover::place(const Vector3 &p_position, double p_heading) {
	ERR_FAIL_COND_MSG(!p_position.is_finite() || !Math::is_finite(p_heading), "Nobody stands at such a place.");
	_state = mover::State();
	_state.position = to_core(p_position);
	_state.heading = float(p_heading);
}

void WalkerMover::follow_body(const Vector3 &p_position, double p_heading) {
	place(p_position, p_heading);
	_state.mode = mover::Mode::BODY;
}

Vector3 WalkerMover::push(const Vector3 &p_motion) {
	mover::Sweep sweep;
	_surroundings.sweep(_state.stance, _state.position, to_core(p_motion), sweep);
	_state.position = _state.position + sweep.travel;
	mover::Frame frame;
	if (_state.carrier != 0 && _surroundings.find_frame(_state.carrier, frame)) {
		_state.local = frame.turn.inverse().rotate(_state.position - frame.origin);
	}
	return from_core(sweep.travel);
}

void WalkerMover::set_hold(const Vector2 &p_hold) {
	ERR_FAIL_COND_MSG(!p_hold.is_finite() || p_hold.length() > 1.001f, "A hold is at most 1 long.");
	_state.hold = { float(p_hold.x), 0.0f, float(p_hold.y) };
}

Vector2 WalkerMover::hold_back(const Vector2 &p_wish) const {
	const mover::Vec3 left = mover::Mover::held(_state, { float(p_wish.x), 0.0f, float(p_wish.y) });
	return Vector2(left.x, left.z);
}

void WalkerMover::tick(const Vector2 &p_wish, double p_heading, int64_t p_stance, bool p_jumps, double p_delta) {
	ERR_FAIL_COND_MSG(!(p_delta > 0.0 && p_delta < 1.0), "A tick lasts more than 0 s and less than 1 s.");
	mover::Wish wish;
	wish.x = float(p_wish.x);
	wish.z = float(p_wish.y);
	wish.heading = float(p_heading);
	wish.stance = mover::Stance(std::clamp<int64_t>(p_stance, 0, mover::STANCES - 1));
	wish.jumps = p_jumps;
	_mover.tick(_state, wish, float(p_delta));
}

PackedByteArray WalkerMover::get_state() const {
	const mover::State::Words words = _state.words();
	PackedByteArray bytes;
	bytes.resize(int64_t(BYTES));
	for (std::size_t i = 0; i < words.size(); i++) {
		bytes.encode_u32(int64_t(i * sizeof(std::uint32_t)), int64_t(words[i]));
	}
	return bytes;
}

bool WalkerMover::set_state(const PackedByteArray &p_bytes) {
	if (p_bytes.size() != int64_t(BYTES)) {
		return false;
	}
	mover::State::Words words{};
	for (std::size_t i = 0; i < words.size(); i++) {
		words[i] = std::uint32_t(p_bytes.decode_u32(int64_t(i * sizeof(std::uint32_t))));
	}
	return _state.read(words);
}

Vector3 WalkerMover::get_position() const {
	return from_core(_state.position);
}

Vector3 WalkerMover::get_velocity() const {
	return from_core(_state.velocity);
}

void WalkerMover::_bind_methods() {
	ClassDB::bind_method(D_METHOD("enter", "space", "world", "mask"), &WalkerMover::enter);
	ClassDB::bind_method(D_METHOD("set_carrier", "body", "number"), &WalkerMover::set_carrier);
	ClassDB::bind_method(D_METHOD("set_ladder", "body", "is_ladder"), &WalkerMover::set_ladder);
	ClassDB::bind_method(D_METHOD("set_passable", "body", "is_passable"), &WalkerMover::set_passable);
	ClassDB::bind_method(D_METHOD("clear_bodies"), &WalkerMover::clear_bodies);
	ClassDB::bind_method(D_METHOD("place", "position", "heading"), &WalkerMover::place);
	ClassDB::bind_method(D_METHOD("follow_body", "position", "heading"), &WalkerMover::follow_body);
	ClassDB::bind_method(D_METHOD("push", "motion"), &WalkerMover::push);
	ClassDB::bind_method(D_METHOD("tick", "wish", "heading", "stance", "jumps", "delta"), &WalkerMover::tick);
	ClassDB::bind_method(D_METHOD("set_hold", "hold"), &WalkerMover::set_hold);
	ClassDB::bind_method(D_METHOD("hold_back", "wish"), &WalkerMover::hold_back);
	ClassDB::bind_method(D_METHOD("get_state"), &WalkerMover::get_state);
	ClassDB::bind_method(D_METHOD("set_state", "bytes"), &WalkerMover::set_state);
	ClassDB::bind_method(D_METHOD("get_check"), &WalkerMover::get_check);
	ClassDB::bind_method(D_METHOD("get_position"), &WalkerMover::get_position);
	ClassDB::bind_method(D_METHOD("get_velocity"), &WalkerMover::get_velocity);
	ClassDB::bind_method(D_METHOD("get_heading"), &WalkerMover::get_heading);
	ClassDB::bind_method(D_METHOD("get_lift"), &WalkerMover::get_lift);
	ClassDB::bind_method(D_METHOD("get_stance"), &WalkerMover::get_stance);
	ClassDB::bind_method(D_METHOD("get_mode"), &WalkerMover::get_mode);
	ClassDB::bind_method(D_METHOD("is_grounded"), &WalkerMover::is_grounded);
	ClassDB::bind_method(D_METHOD("get_carrier"), &WalkerMover::get_carrier);
	BIND_ENUM_CONSTANT(STAND);
	BIND_ENUM_CONSTANT(CROUCH);
	BIND_ENUM_CONSTANT(PRONE);
	BIND_ENUM_CONSTANT(WALK);
	BIND_ENUM_CONSTANT(VAULT);
	BIND_ENUM_CONSTANT(LADDER);
	BIND_ENUM_CONSTANT(BODY);
}

} // namespace godot
