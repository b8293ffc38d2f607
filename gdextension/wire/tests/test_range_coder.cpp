// SPDX-License-Identifier: MIT
#include <check.hpp>
#include <range_coder.hpp>

#include <array>
#include <random>
#include <vector>

namespace test_range_coder {

using namespace wire;

namespace {

struct Symbol {
	uint32_t below;
	uint32_t share;
	int bits;
};

std::vector<Symbol> draw(std::mt19937 &p_random, int p_count) {
	std::vector<Symbol> symbols;
	for (int i = 0; i < p_count; i++) {
		const uint32_t bits = 1 + uint32_t(p_random() % 16);
		const uint32_t below = p_random() % (1U << bits);
		const uint32_t most = (1U << bits) - below;
		// Often a single unit, often all that is left: the ends of what can be.
		const uint32_t share = i % 3 == 0 ? 1 : (i % 3 == 1 ? most : 1 + p_random() % most);
		symbols.push_back({ below, share, int(bits) });
	}
	return symbols;
}

bool reads_back(const std::vector<Symbol> &p_symbols, const uint8_t *p_bytes, std::size_t p_size, std::size_t &r_used) {
	RangeDecoder decoder(p_bytes, p_size);
	for (const Symbol &symbol : p_symbols) {
		const uint32_t position = decoder.peek(symbol.bits);
		if (position < symbol.below || position >= symbol.below + symbol.share) {
			return false;
		}
		decoder.decode(symbol.below, symbol.share);
	}
	r_used = decoder.used();
	return !decoder.is_bad();
}

} // namespace

TEST(what_is_written_is_read_and_its_end_found_whatever_follows) {
	std::mt19937 random(1);
	std::array<uint8_t, 4096> buffer{};
	int wrong = 0;
	for (int round = 0; round < 3000; round++) {
		const std::vector<Symbol> symbols = draw(random, int(random() % 300));
		RangeEncoder encoder(buffer.data(), buffer.size());
		for (const Symbol &symbol : symbols) {
			encoder.encode(symbol.below, symbol.share, symbol.bits);
		}
		const std::size_t size = encoder.finish();
		for (const int filler : { 0, 255, int(random() % 256) }) {
			for (std::size_t i = size; i < size + 8; i++) {
				buffer[i] = uint8_t(filler);
			}
			std::size_t used = 0;
			wrong += reads_back(symbols, buffer.data(), size + 8, used) && used == size ? 0 : 1;
		}
	}
	CHECK(wrong == 0);
}

TEST(bits_and_numbers) {
	std::array<uint8_t, 64> buffer{};
	RangeEncoder encoder(buffer.data(), buffer.size());
	encoder.encode_bits(0xDEADBEEF, 32);
	encoder.encode_bits(0, 0);
	encoder.encode_bits(5, 3);
	encoder.encode_bit(true, 65000);
	encoder.encode_bit(false, 65000);
	const std::size_t size = encoder.finish();
	CHECK(size == 6 || size == 7);
	RangeDecoder decoder(buffer.data(), size);
	CHECK(decoder.decode_bits(32) == 0xDEADBEEF);
	CHECK(decoder.decode_bits(0) == 0);
	CHECK(decoder.decode_bits(3) == 5);
	CHECK(decoder.decode_bit(65000));
	CHECK(!decoder.decode_bit(65000));
	CHECK(!decoder.is_bad());
}

TEST(likely_symbols_take_few_bytes) {
	std::array<uint8_t, 64> buffer{};
	RangeEncoder encoder(buffer.data(), buffer.size());
	for (int i = 0; i < 1000; i++) {
		encoder.encode_bit(false, 65000);
	}
	CHECK(encoder.finish() <= 3);
}

TEST(a_buffer_that_is_too_small_is_noticed) {
	std::array<uint8_t, 4> buffer{};
	RangeEncoder encoder(buffer.data(), 3);
	for (int i = 0; i < 10; i++) {
		encoder.encode_bits(0xFF, 8);
	}
	CHECK(encoder.finish() == 0);
	CHECK(buffer[3] == 0);
}

TEST(what_is_cut_off_is_noticed) {
	std::array<uint8_t, 64> buffer{};
	RangeEncoder encoder(buffer.data(), buffer.size());
	for (int i = 0; i < 20; i++) {
		encoder.encode_bits(uint32_t(i), 8);
	}
	const std::size_t size = encoder.finish();
	RangeDecoder decoder(buffer.data(), size - 1);
	for (int i = 0; i < 20; i++) {
		decoder.decode_bits(8);
	}
	CHECK(decoder.is_bad());
}

} // namespace test_range_coder
