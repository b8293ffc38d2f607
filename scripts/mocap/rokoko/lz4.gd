class_name Lz4
extends RefCounted
## Unpacks LZ4 frames (frame format 1.6 and block format of lz4.org). It does not verify their
## checksums: UDP has its own.

const _MAGIC: int = 0x184D2204
## Flags of the frame: blocks have checksums, the frame has the size of its content, a dictionary is
## named.
const _BLOCK_CHECKSUM: int = 0x10
const _CONTENT_SIZE: int = 0x08
const _DICTIONARY: int = 0x01


## Whether bytes begin with the magic number of a frame.
static func is_frame(p_bytes: PackedByteArray) -> bool:
	return p_bytes.size() >= 7 and p_bytes.decode_u32(0) == _MAGIC


## The content of a frame, at most [param p_limit] bytes; empty if the bytes are no frame.
static func unpack(p_bytes: PackedByteArray, p_limit: int) -> PackedByteArray:
	var flags: int = p_bytes[4]
	if flags >> 6 != 1 or flags & _DICTIONARY != 0:
		return PackedByteArray()
	var at: int = 7 + (8 if flags & _CONTENT_SIZE != 0 else 0)
	var unpacked: PackedByteArray = PackedByteArray()
	while at + 4 <= p_bytes.size():
		var size: int = p_bytes.decode_u32(at)
		at += 4
		if size == 0:
			return unpacked
		var is_plain: bool = size & 0x80000000 != 0
		size &= 0x7FFFFFFF
		if size > p_bytes.size() - at or unpacked.size() + size > 2 * p_limit:
			return PackedByteArray()
		if is_plain:
			unpacked.append_array(p_bytes.slice(at, at + size))
		elif not _unpack_block(p_bytes, at, at + size, unpacked, p_limit):
			return PackedByteArray()
		if unpacked.size() > p_limit:
			return PackedByteArray()
		at += size + (4 if flags & _BLOCK_CHECKSUM != 0 else 0)
	return PackedByteArray()


## Appends the content of a block. Returns false if the bytes are no block.
static func _unpack_block(
	p_bytes: PackedByteArray, p_begin: int, p_end: int, r_out: PackedByteArray, p_limit: int
) -> bool:
	var at: int = p_begin
	while at < p_end:
		var token: int = p_bytes[at]
		at += 1
		var count: int = token >> 4
		if count == 15:
			while at < p_end:
				count += p_bytes[at]
				at += 1
				if p_bytes[at - 1] != 255:
					break
		if count > p_end - at or r_out.size() + count > p_limit:
			return false
		r_out.append_array(p_bytes.slice(at, at + count))
		at += count
		if at >= p_end:
			# The last sequence has no match.
			return at == p_end
		if p_end - at < 2:
			return false
		var back: int = p_bytes.decode_u16(at)
		at += 2
		count = token & 15
		if count == 15:
			while at < p_end:
				count += p_bytes[at]
				at += 1
				if p_bytes[at - 1] != 255:
					break
		count += 4
		if back == 0 or back > r_out.size() or r_out.size() + count > p_limit:
			return false
		_repeat(r_out, back, count)
	return true


## Appends [param p_count] bytes from [param p_back] bytes before the end; they may overlap those
## that are being appended.
static func _repeat(r_out: PackedByteArray, p_back: int, p_count: int) -> void:
	var left: int = p_count
	var begin: int = r_out.size() - p_back
	while left > 0:
		var piece: int = mini(left, r_out.size() - begin)
		r_out.append_array(r_out.slice(begin, begin + piece))
		left -= piece
