// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <cstddef>

namespace usb {

/// A queue between one thread that writes and one that reads, without locks and without allocation.
///
/// Holds `Size` - 1 entries at most; `Size` is a power of two.
template <class T, std::size_t Size>
class Ring {
	static_assert((Size & (Size - 1)) == 0, "the size is a power of two");

public:
	/// The entry to be written next, or null where the reader is too far behind. For the writer.
	T *claim() {
		const std::size_t write = _write.load(std::memory_order_relaxed);
		const std::size_t next = (write + 1) & (Size - 1);
		return next == _read.load(std::memory_order_acquire) ? nullptr : &_entries[write];
	}

	/// Hands the claimed entry to the reader. For the writer.
	void publish() {
		const std::size_t write = _write.load(std::memory_order_relaxed);
		_write.store((write + 1) & (Size - 1), std::memory_order_release);
	}

	/// The oldest entry, or null. It stays until `drop`. For the reader.
	const T *front() const {
		const std::size_t read = _read.load(std::memory_order_relaxed);
		return read == _write.load(std::memory_order_acquire) ? nullptr : &_entries[read];
	}

	/// Gives the oldest entry back. For the reader.
	void drop() {
		const std::size_t read = _read.load(std::memory_order_relaxed);
		_read.store((read + 1) & (Size - 1), std::memory_order_release);
	}

private:
	std::array<T, Size> _entries{};
	alignas(64) std::atomic<std::size_t> _write{ 0 };
	alignas(64) std::atomic<std::size_t> _read{ 0 };
};

} // namespace usb
