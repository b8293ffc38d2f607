// SPDX-License-Identifier: MIT
#include "person_stream.hpp"

#include <array>
#include <chrono>

namespace godot {

namespace {

using Bytes = std::array<uint8_t, wire::PersonCodec::MAX_BYTES>;

double microseconds_since(std::chrono::steady_clock::time_point p_start) {
	return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - p_start).count();
}

} // namespace

int PersonStream::resolution_for(double p_max_error_deg) {
	return wire::PersonLattice::resolution_for(p_max_error_deg);
}

bool PersonStream::setup(const PackedInt32Array &p_parents, int p_resolution) {
	wire::Skeleton wanted;
	if (p_parents.size() > kinematics::MAX_LIMBS) {
		return false;
	}
	wanted.limb_count = int(p_parents.size());
	for (int64_t i = 0; i < p_parents.size(); i++) {
		wanted.parents[std::size_t(i)] = p_parents.ptr()[i];
	}
	if (!wanted.is_sound()) {
		return false;
	}
	_skeleton = wanted;
	_resolution = wire::PersonLattice(p_resolution).resolution();
	_states.clear();
	return true;
}

int PersonStream::push(const Vector3 &p_root, const PackedFloat32Array &p_orientations) {
	if (_skeleton.limb_count == 0 || p_orientations.size() != 4 * _skeleton.limb_count) {
		return -1;
	}
	wire::PersonPose pose;
	pose.root = { p_root.x, p_root.y, p_root.z };
	const float *values = p_orientations.ptr();
	for (std::size_t i = 0; i < std::size_t(_skeleton.limb_count); i++) {
		pose.orientations[i] = { values[4 * i], values[4 * i + 1], values[4 * i + 2], values[4 * i + 3] };
	}
	wire::PersonState state;
	if (!wire::PersonLattice(_resolution)
					.quantise(pose, _skeleton, _states.empty() ? nullptr : &_states.back(), state)) {
		return -1;
	}
	_states.push_back(state);
	return int(_states.size()) - 1;
}

std::size_t PersonStream::_write(int p_tick, int p_base, int p_before, uint8_t *r_bytes) const {
	wire::RangeEncoder encoder(r_bytes, wire::PersonCodec::MAX_BYTES);
	wire::PersonCodec(_skeleton, _resolution)
			.encode(encoder, _states[std::size_t(p_tick)], _state_or_null(p_base), _state_or_null(p_before),
					p_tick - p_base, p_tick - p_before);
	return encoder.finish();
}

bool PersonStream::_read(const uint8_t *p_bytes, std::size_t p_size, int p_tick, int p_base, int p_before,
		wire::PersonState &r_state) const {
	wire::RangeDecoder decoder(p_bytes, p_size);
	return wire::PersonCodec(_skeleton, _resolution)
				   .decode(decoder, r_state, _state_or_null(p_base), _state_or_null(p_before), p_tick - p_base,
						   p_tick - p_before) &&
			decoder.used() == p_size;
}

PackedByteArray PersonStream::encode(int p_tick, int p_base, int p_before) const {
	PackedByteArray bytes;
	if (_is_tick(p_tick)) {
		Bytes buffer{};
		const std::size_t size = _write(p_tick, p_base, p_before, buffer.data());
		bytes.resize(int64_t(size));
		std::copy(buffer.begin(), buffer.begin() + std::ptrdiff_t(size), bytes.ptrw());
	}
	return bytes;
}

bool PersonStream::decode(const PackedByteArray &p_bytes, int p_tick, int p_base, int p_before) const {
	wire::PersonState found;
	if (!_is_tick(p_tick) || !_read(p_bytes.ptr(), std::size_t(p_bytes.size()), p_tick, p_base, p_before, found)) {
		return false;
	}
	const wire::PersonState &state = _states[std::size_t(p_tick)];
	for (std::size_t i = 0; i < std::size_t(_skeleton.limb_count); i++) {
		if (!(found.limbs[i] == state.limbs[i])) {
			return false;
		}
	}
	return found.root == state.root;
}

PackedFloat32Array PersonStream::restore(int p_tick) const {
	PackedFloat32Array orientations;
	if (!_is_tick(p_tick)) {
		return orientations;
	}
	wire::PersonPose pose;
	wire::PersonLattice(_resolution).restore(_states[std::size_t(p_tick)], _skeleton, pose);
	orientations.resize(4 * _skeleton.limb_count);
	float *values = orientations.ptrw();
	for (std::size_t i = 0; i < std::size_t(_skeleton.limb_count); i++) {
		const kinematics::Quat &rotation = pose.orientations[i];
		values[4 * i] = rotation.x;
		values[4 * i + 1] = rotation.y;
		values[4 * i + 2] = rotation.z;
		values[4 * i + 3] = rotation.w;
	}
	return orientations;
}

Vector2 PersonStream::measure(int p_every, int p_age, int p_before_age, int p_rounds) const {
	double encoding = 0.0;
	double decoding = 0.0;
	int count = 0;
	Bytes buffer{};
	for (int tick = p_before_age; p_every > 0 && p_age > 0 && p_before_age >= p_age && _is_tick(tick);
			tick += p_every) {
		std::size_t size = 0;
		const auto start = std::chrono::steady_clock::now();
		for (int i = 0; i < p_rounds; i++) {
			size = _write(tick, tick - p_age, tick - p_before_age, buffer.data());
		}
		encoding += microseconds_since(start);
		const auto between = std::chrono::steady_clock::now();
		wire::PersonState found;
		for (int i = 0; i < p_rounds; i++) {
			count += _read(buffer.data(), size, tick, tick - p_age, tick - p_before_age, found) ? 1 : 0;
		}
		decoding += microseconds_since(between);
	}
	return count > 0 ? Vector2(float(encoding / count), float(decoding / count)) : Vector2();
}

void PersonStream::_bind_methods() {
	ClassDB::bind_static_method(
			"PersonStream", D_METHOD("resolution_for", "max_error_deg"), &PersonStream::resolution_for);
	ClassDB::bind_method(D_METHOD("setup", "parents", "resolution"), &PersonStream::setup);
	ClassDB::bind_method(D_METHOD("push", "root", "orientations"), &PersonStream::push);
	ClassDB::bind_method(D_METHOD("encode", "tick", "base", "before"), &PersonStream::encode);
	ClassDB::bind_method(D_METHOD("decode", "bytes", "tick", "base", "before"), &PersonStream::decode);
	ClassDB::bind_method(D_METHOD("restore", "tick"), &PersonStream::restore);
	ClassDB::bind_method(D_METHOD("measure", "every", "age", "before_age", "rounds"), &PersonStream::measure);
}

} // namespace godot
