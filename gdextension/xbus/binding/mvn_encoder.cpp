// SPDX-License-Identifier: MIT
#include "mvn_encoder.hpp"

#include "mvn_dictionary.hpp"

#include <mvn/encoder.hpp>

#include <godot_cpp/core/error_macros.hpp>

#include <algorithm>

namespace godot {

TypedArray<PackedByteArray> MvnEncoder::encode(const Dictionary &p_sample, int64_t p_most_bytes) {
	TypedArray<PackedByteArray> datagrams;
	mvn::Content content;
	const String fault = mvn_from_dictionary(p_sample, content);
	ERR_FAIL_COND_V_MSG(!fault.is_empty(), datagrams, String("This is no sample of MVN's: ") + fault + ".");
	const std::size_t most = std::size_t(std::clamp<int64_t>(p_most_bytes, 128, mvn::MAX_DATAGRAM));
	for (const mvn::Bytes &bytes : mvn::encode(content, most)) {
		PackedByteArray datagram;
		datagram.resize(int64_t(bytes.size()));
		std::copy(bytes.begin(), bytes.end(), datagram.ptrw());
		datagrams.push_back(datagram);
	}
	ERR_FAIL_COND_V_MSG(datagrams.is_empty(), datagrams, "The sample is too large for MVN's stream.");
	return datagrams;
}

PackedStringArray MvnEncoder::get_segment_names() {
	PackedStringArray names;
	for (const char *name : mvn::SEGMENT_NAMES) {
		names.push_back(name);
	}
	return names;
}

void MvnEncoder::_bind_methods() {
	ClassDB::bind_static_method(get_class_static(), D_METHOD("encode", "sample", "most_bytes"), &MvnEncoder::encode,
			DEFVAL(int64_t(mvn::MAX_SENT)));
	ClassDB::bind_static_method(get_class_static(), D_METHOD("get_segment_names"), &MvnEncoder::get_segment_names);
}

} // namespace godot
