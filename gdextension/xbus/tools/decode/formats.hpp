// SPDX-License-Identifier: MIT
#pragma once

#include "analysis.hpp"

/// Collects what messages say about the format of MTData.
class FormatBook {
public:
	explicit FormatBook(const FormatOptions &p_options);

	/// Takes note of a message: a configuration, a list of devices, an output mode or settings.
	void note(const xbus::Frame &p_frame);
	/// The format of a message of this size: the newest that fits, else -1.
	int pick(std::size_t p_size) const;
	/// Adds one that was guessed.
	int add(const DataFormat &p_format);

	const std::vector<DataFormat> &formats() const { return _formats; }
	/// Trackers behind the master, 0 if none is known.
	std::size_t trackers() const { return _trackers; }

private:
	void _note_configuration(const xbus::Frame &p_frame);
	/// From the modes and settings that were set one by one.
	void _combine();

	std::vector<DataFormat> _formats;
	std::array<xbus::OutputFormat, 256> _set{};
	std::array<bool, 256> _is_set{};
	std::size_t _trackers = 0;
};

/// Decodes an MTData message into the samples of its trackers; none, and false, if the format is not its own.
bool decode_frame(const DataFormat &p_format, const xbus::Frame &p_frame, std::vector<xbus::FullSample> &r_samples);

/// Which format makes sense of all these messages of one size, if just one does. `p_trackers`: behind the master,
/// 0 if that is not known.
std::optional<DataFormat> guess_format(const std::vector<xbus::Frame> &p_frames, std::size_t p_trackers);
