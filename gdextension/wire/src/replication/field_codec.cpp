// SPDX-License-Identifier: MIT
#include "replication/field_codec.hpp"

#include <algorithm>

namespace wire {

void FieldCodec::encode(
		RangeEncoder &p_encoder, const EntityType &p_type, const uint32_t *p_base, const uint32_t *p_now) {
	bool before = false;
	for (std::size_t i = 0; i < p_type.fields.size(); i++) {
		const bool changed = p_base[i] != p_now[i];
		_changes[i][before ? 1 : 0].encode(p_encoder, changed);
		before = changed;
		if (changed) {
			Model &model = _models[std::min(i, MODELS - 1)];
			_encode_difference(p_encoder, model, p_type.fields[i].difference(p_base[i], p_now[i]));
		}
	}
}

bool FieldCodec::decode(RangeDecoder &p_decoder, const EntityType &p_type, const uint32_t *p_base, uint32_t *r_now) {
	bool before = false;
	for (std::size_t i = 0; i < p_type.fields.size(); i++) {
		const bool changed = _changes[i][before ? 1 : 0].decode(p_decoder);
		before = changed;
		r_now[i] = p_base[i];
		if (changed) {
			Model &model = _models[std::min(i, MODELS - 1)];
			if (!p_type.fields[i].add(p_base[i], _decode_difference(p_decoder, model), r_now[i])) {
				return false;
			}
		}
	}
	return !p_decoder.is_bad();
}

void FieldCodec::_encode_difference(RangeEncoder &p_encoder, Model &r_model, int32_t p_difference) {
	const uint32_t size = uint32_t(p_difference < 0 ? -p_difference : p_difference);
	int length = 0;
	while ((size >> uint32_t(length)) > 1) {
		length++;
	}
	std::size_t node = 1;
	for (int i = LENGTH_BITS - 1; i >= 0; i--) {
		const bool one = ((uint32_t(length) >> uint32_t(i)) & 1U) != 0;
		r_model.length[node].encode(p_encoder, one);
		node = 2 * node + (one ? 1 : 0);
	}
	p_encoder.encode_bits(size, length);
	r_model.sign.encode(p_encoder, p_difference < 0);
}

int32_t FieldCodec::_decode_difference(RangeDecoder &p_decoder, Model &r_model) {
	std::size_t node = 1;
	for (int i = 0; i < LENGTH_BITS; i++) {
		node = 2 * node + (r_model.length[node].decode(p_decoder) ? 1 : 0);
	}
	// Lengths beyond that of the largest number only come in damaged bytes; they fit in 32 bits all the same.
	const int length = std::min(int(node - (1U << LENGTH_BITS)), 30);
	const int32_t size = int32_t((1U << uint32_t(length)) | p_decoder.decode_bits(length));
	return r_model.sign.decode(p_decoder) ? -size : size;
}

} // namespace wire
