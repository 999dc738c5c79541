#include <halfedge/io/ply_faces.h>
#include <halfedge/io/ply_lists.h>
#include <halfedge/io/ply_reader.h>
#include <halfedge/io/ply_vertices.h>

#include <optional>
#include <utility>

namespace halfedge {
namespace io {
namespace {

template <class Source>
Result<ParsedFile> read_rows(std::span<const std::uint8_t> bytes, const PlyHeader& header,
                             Source source, const Request& request) {
  PlyReader<Source> reader(header, std::move(source), request);
  reader.out().follow(bytes, request.options.progress);
  if (std::optional<Error> error = reader.read()) return *std::move(error);
  const bool binary = header.encoding != PlyEncoding::kText;
  return ParsedFile{Format::kPly, std::move(reader.out().soup()), reader.notes(), binary,
                    std::move(reader.columns())};
}

}  // namespace

Result<ParsedFile> read_ply(std::span<const std::uint8_t> bytes, const Request& request) {
  Result<PlyHeader> header = read_ply_header(bytes);
  if (!header) return header;
  const std::size_t start = header.value().size;
  switch (header.value().encoding) {
    case PlyEncoding::kText:
      return read_rows(bytes, header.value(),
                       PlyText(without_padding(bytes), start, header.value().rows()), request);
    case PlyEncoding::kLittleEndian:
      return read_rows(bytes, header.value(), PlyBinary(bytes, start, ByteOrder::kLittle), request);
    case PlyEncoding::kBigEndian:
      return read_rows(bytes, header.value(), PlyBinary(bytes, start, ByteOrder::kBig), request);
  }
  return Error{"parse-error", "the encoding of the file does not exist"};
}

}  // namespace io

Result<ParsedFile> read_ply(std::span<const std::uint8_t> bytes, const ParseOptions& options) {
  return io::read_ply(bytes, {options});
}

}  // namespace halfedge
