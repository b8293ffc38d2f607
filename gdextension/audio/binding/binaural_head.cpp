// SPDX-License-Identifier: MIT
#include "binaural_head.hpp"

#include <vector>

namespace godot {

String BinauralHead::open(const PackedByteArray &p_bytes, double p_rate) {
	const std::vector<char> bytes(p_bytes.ptr(), p_bytes.ptr() + p_bytes.size());
	return _head.open(bytes, float(p_rate)).c_str();
}

PackedFloat32Array BinauralHead::find_filter(const Vector3 &p_direction) const {
	PackedFloat32Array taps;
	if (!_head.is_open()) {
		return taps;
	}
	const audio::Ears ears = _head.find(float(p_direction.x), float(p_direction.y), float(p_direction.z));
	taps.resize(int64_t(2 * audio::TAPS));
	for (std::size_t i = 0; i < audio::TAPS; i++) {
		taps.set(int64_t(i), ears.left[i]);
		taps.set(int64_t(audio::TAPS + i), ears.right[i]);
	}
	return taps;
}

void BinauralHead::_bind_methods() {
	ClassDB::bind_method(D_METHOD("open", "bytes", "rate"), &BinauralHead::open);
	ClassDB::bind_method(D_METHOD("is_open"), &BinauralHead::is_open);
	ClassDB::bind_method(D_METHOD("find_filter", "direction"), &BinauralHead::find_filter);
}

} // namespace godot
