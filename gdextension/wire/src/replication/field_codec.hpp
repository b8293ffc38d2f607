// SPDX-License-Identifier: MIT
#pragma once

#include "range_coder.hpp"
#include "replication/entity_type.hpp"

namespace wire {

/// A bit whose chance follows those before it.
class AdaptiveBit {
public:
	void encode(RangeEncoder &p_encoder, bool p_one) {
		p_encoder.encode_bit(p_one, _zero);
		_learn(p_one);
	}
	bool decode(RangeDecoder &p_decoder) {
		const bool one = p_decoder.decode_bit(_zero);
		_learn(one);
		return one;
	}

private:
	static constexpr uint32_t RATE = 4;
	static constexpr uint32_t MIN_CHANCE = 1024; // Of 65536.

	void _learn(bool p_one) {
		_zero = p_one ? _zero - ((_zero - MIN_CHANCE) >> RATE) : _zero + ((65536 - MIN_CHANCE - _zero) >> RATE);
	}

	uint32_t _zero = 1U << 15U;
};

/// How the fields of entities are written, one entity after the other in one message: which of them differ from a
/// base that the receiver has, and by how much. Frequencies adapt while a message is read, anew in each.
class FieldCodec {
public:
	/// Bytes that an entity with so many fields that differ takes at most.
	static constexpr std::size_t max_bytes(std::size_t p_changed) { return 16 + 9 * p_changed; }

	void encode(RangeEncoder &p_encoder, const EntityType &p_type, const uint32_t *p_base, const uint32_t *p_now);
	/// Returns false where what is read can be no fields.
	bool decode(RangeDecoder &p_decoder, const EntityType &p_type, const uint32_t *p_base, uint32_t *r_now);

private:
	static constexpr int LENGTH_BITS = 5;
	// Fields of higher numbers share their statistics.
	static constexpr std::size_t MODELS = 8;

	struct Model {
		std::array<AdaptiveBit, 1U << LENGTH_BITS> length; // A binary tree.
		AdaptiveBit sign;
	};

	void _encode_difference(RangeEncoder &p_encoder, Model &r_model, int32_t p_difference);
	int32_t _decode_difference(RangeDecoder &p_decoder, Model &r_model);

	std::array<std::array<AdaptiveBit, 2>, MAX_FIELDS> _changes{}; // By field, and whether the one before changed.
	std::array<Model, MODELS> _models{};
};

} // namespace wire
