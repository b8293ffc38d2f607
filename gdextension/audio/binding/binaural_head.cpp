// SPDX-License-Identifier: MIT
#include "binaural_head.hpp"

#include <vector>

namespace godot {

String BinauralHead::open(const PackedByteArray &p_bytes, double p_rate) {
	const std::vector<char> bytes(p_bytes.ptr(), p_bytes.ptr() + p_bytes.size());
	return _head.open(bytes, float(p_rate)).c_str();
}

void BinauralHead::_bind_methods() {
	ClassDB::bind_method(D_METHOD("open", "bytes", "rate"), &BinauralHead::open);
	ClassDB::bind_method(D_METHOD("is_open"), &BinauralHead::is_open);
}

} // namespace godot
