// SPDX-License-Identifier: GPL-2.0-only
// Types and files of MPI that are given back whatever happens, and reasons that all ranks agree on.

#ifndef LBM_MPI_H
#define LBM_MPI_H

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>

#ifndef OMPI_SKIP_MPICXX
#define OMPI_SKIP_MPICXX 1    // the deprecated C++ bindings only bring warnings
#endif
#include <mpi.h>

namespace lbm {

// the first rank that has something to say speaks for all
inline std::string agreed(const std::string &mine, MPI_Comm comm)
{
  int me, ranks, first;
  MPI_Comm_rank(comm, &me);
  MPI_Comm_size(comm, &ranks);
  const int speaker = mine.empty() ? ranks : me;
  MPI_Allreduce(&speaker, &first, 1, MPI_INT, MPI_MIN, comm);
  if (first == ranks) return "";
  int length = int(mine.size());
  MPI_Bcast(&length, 1, MPI_INT, first, comm);
  std::string text = mine;
  text.resize(length);
  MPI_Bcast(&text[0], length, MPI_CHAR, first, comm);
  return text;
}

inline std::string error_text(int code)
{
  if (code == MPI_SUCCESS) return "";
  char text[MPI_MAX_ERROR_STRING];
  int length = 0;
  MPI_Error_string(code, text, &length);
  return std::string(text, length);
}

// so many bytes, counted as one
class Type {
 public:
  explicit Type(int bytes)
  {
    MPI_Type_contiguous(bytes, MPI_BYTE, &type_);
    MPI_Type_commit(&type_);
  }
  ~Type() { MPI_Type_free(&type_); }
  Type(const Type &) = delete;
  Type &operator=(const Type &) = delete;
  MPI_Datatype handle() const { return type_; }

 private:
  MPI_Datatype type_ = MPI_DATATYPE_NULL;
};

// a file that is closed in any case, and whose first error is kept
class File {
 public:
  File(const std::string &name, int mode, MPI_Comm comm) : comm_(comm)
  {
    code_ = MPI_File_open(comm, name.c_str(), mode, MPI_INFO_NULL, &file_);
    open_ = code_ == MPI_SUCCESS;
  }
  ~File() { close(); }
  File(const File &) = delete;
  File &operator=(const File &) = delete;

  MPI_File handle() const { return file_; }
  MPI_Comm comm() const { return comm_; }
  void keep(int code)
  {
    if (code_ == MPI_SUCCESS) code_ = code;
  }
  void keep(int code, const MPI_Status &status, std::int64_t bytes)
  {
    keep(code);
    MPI_Count got = 0;
    MPI_Get_elements_x(&status, MPI_BYTE, &got);
    if (code == MPI_SUCCESS && got != bytes) keep(MPI_ERR_IO);
  }
  std::string error() const { return agreed(error_text(code_), comm_); }
  std::int64_t size() const
  {
    MPI_Offset bytes = 0;
    MPI_File_get_size(file_, &bytes);
    return bytes;
  }
  void close()
  {
    if (open_) keep(MPI_File_close(&file_));
    open_ = false;
  }

 private:
  MPI_Comm comm_;
  MPI_File file_ = MPI_FILE_NULL;
  bool open_ = false;
  int code_ = MPI_SUCCESS;
};

// A file written aside, as NAME.part, and renamed when it is complete: NAME is whole at any moment.
class NewFile : public File {
 public:
  NewFile(const std::string &name, MPI_Comm comm) :
      File(cleared(name + ".part", comm), MPI_MODE_CREATE | MPI_MODE_WRONLY, comm), name_(name)
  {
  }

  // what one rank has, of any size
  void write(std::int64_t at, const void *from, std::int64_t bytes)
  {
    constexpr std::int64_t MOST = std::int64_t(1) << 30;
    for (std::int64_t done = 0; done < bytes; done += MOST) {
      const int now = int(std::min(MOST, bytes - done));
      MPI_Status status;
      const int code = MPI_File_write_at(
          handle(), at + done, static_cast<const char *>(from) + done, now, MPI_BYTE, &status);
      keep(code, status, now);
    }
  }

  // collective; why it has not become a file of so many bytes, "" if it has
  std::string finish(std::int64_t bytes)
  {
    const std::string aside = name_ + ".part";
    int me;
    MPI_Comm_rank(comm(), &me);
    keep(MPI_File_sync(handle()));
    const std::int64_t got = size();
    close();
    std::string why = error();
    if (why.empty() && got != bytes)
      why = "there was room for " + std::to_string(got) + " of " + std::to_string(bytes) + " bytes";
    if (!why.empty()) {
      if (me == 0) std::remove(aside.c_str());
      return "cannot write " + aside + ": " + why;
    }
    if (me == 0 && std::rename(aside.c_str(), name_.c_str()) != 0)
      why = "cannot rename " + aside + " to " + name_ + ": " + std::strerror(errno);
    return agreed(why, comm());
  }

 private:
  std::string name_;

  // nothing is left of an older one that may have been longer
  static std::string cleared(const std::string &aside, MPI_Comm comm)
  {
    int me;
    MPI_Comm_rank(comm, &me);
    if (me == 0) std::remove(aside.c_str());
    MPI_Barrier(comm);
    return aside;
  }
};

}    // namespace lbm
#endif
