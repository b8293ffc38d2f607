// SPDX-License-Identifier: MIT
#include "sealed_state.hpp"

#include <cstring>

namespace godot {

namespace {

constexpr std::size_t SEAL = sizeof(std::uint64_t);

std::uint64_t find_sum(const std::uint8_t *p_bytes, std::size_t p_size) {
	ragdoll::StateHash sum;
	for (std::size_t i = 0; i < p_size; i++) {
		sum.add(p_bytes[i]);
	}
	return sum.get();
}

} // namespace

PackedByteArray seal(ragdoll::ArchiveWriter &r_archive) {
	r_archive.put(find_sum(r_archive.get_bytes().data(), r_archive.get_bytes().size()));
	const std::vector<std::uint8_t> &bytes = r_archive.get_bytes();
	PackedByteArray result;
	result.resize(int64_t(bytes.size()));
	std::memcpy(result.ptrw(), bytes.data(), bytes.size());
	return result;
}

String find_seal_fault(const PackedByteArray &p_bytes) {
	const std::size_t size = std::size_t(p_bytes.size());
	if (size < SEAL) {
		return "the saved state is cut off";
	}
	std::uint64_t expected = 0;
	std::memcpy(&expected, p_bytes.ptr() + size - SEAL, SEAL);
	return find_sum(p_bytes.ptr(), size - SEAL) != expected ? String("the saved state is damaged") : String();
}

ragdoll::ArchiveReader open_sealed(const PackedByteArray &p_bytes) {
	return ragdoll::ArchiveReader(p_bytes.ptr(), std::size_t(p_bytes.size()) - SEAL);
}

} // namespace godot
