// SPDX-License-Identifier: MIT
#pragma once

// Counts what a test program allocates. Include it in one source of the program only: it replaces the
// program's own operators.

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

/// Of all threads.
std::atomic<int> allocations{ 0 };

} // namespace

void *operator new(std::size_t p_size) {
	allocations++;
	void *found = std::malloc(p_size);
	if (found == nullptr) {
		throw std::bad_alloc();
	}
	return found;
}

void *operator new(std::size_t p_size, const std::nothrow_t &) noexcept {
	allocations++;
	return std::malloc(p_size);
}

void operator delete(void *p_memory) noexcept {
	std::free(p_memory);
}

void operator delete(void *p_memory, std::size_t) noexcept {
	std::free(p_memory);
}
