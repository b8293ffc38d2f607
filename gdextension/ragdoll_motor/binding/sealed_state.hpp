// SPDX-License-Identifier: MIT
#pragma once

#include <base/archive.hpp>

#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/string.hpp>

namespace godot {

/// The bytes of an archive, and a checksum of them at the end.
PackedByteArray seal(ragdoll::ArchiveWriter &r_archive);

/// Why these are not sealed bytes, or an empty text.
String find_seal_fault(const PackedByteArray &p_bytes);

/// A reader of sealed bytes that have no fault; they must live as long.
ragdoll::ArchiveReader open_sealed(const PackedByteArray &p_bytes);

} // namespace godot
