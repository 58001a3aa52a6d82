# Install/unInstall package files in LAMMPS (traditional make)
# mode = 0/1/2 for uninstall/install/update

mode=$1

# enforce using portable C locale
LC_ALL=C
export LC_ALL

# arg1 = file, arg2 = file it depends on

action () {
  if (test $mode = 0) then
    rm -f ../$1
  elif (! cmp -s $1 ../$1) then
    if (test -z "$2" || test -e ../$2) then
      cp $1 ..
      if (test $mode = 2) then
        echo "  updating src/$1"
      fi
    fi
  elif (test -n "$2") then
    if (test ! -e ../$2) then
      rm -f ../$1
    fi
  fi
}

# this package derives from classes of package GRANULAR

if (test $mode = 1) then
  if (test ! -e ../granular_model.h) then
    echo "Must install GRANULAR package with LBM-IBB: make yes-granular"
    exit 1
  fi
fi

# all package files with no dependencies

for file in *.cpp *.h; do
  test -f ${file} && action $file
done

# edit the 2 Makefile.package files: Eigen's headers, zlib, and the compiler flags of our own files;
# Makefile.lammps in this folder has both

if (test $mode = 1) then

  if (test -e ../Makefile.package) then
    sed -i -e 's/[^ \t]*lbm_ibb[^ \t]* //' ../Makefile.package
    sed -i -e 's|^PKG_SYSINC =[ \t]*|&$(lbm_ibb_SYSINC) |' ../Makefile.package
    sed -i -e 's|^PKG_SYSLIB =[ \t]*|&$(lbm_ibb_SYSLIB) |' ../Makefile.package
  fi

  if (test -e ../Makefile.package.settings) then
    sed -i -e '/^[ \t]*include.*LBM-IBB.*$/d' ../Makefile.package.settings
    # multiline form needed for BSD sed on Macs
    sed -i -e '4 i \
include ..\/LBM-IBB\/Makefile.lammps
' ../Makefile.package.settings
  fi

elif (test $mode = 0) then

  if (test -e ../Makefile.package) then
    sed -i -e 's/[^ \t]*lbm_ibb[^ \t]* //' ../Makefile.package
  fi

  if (test -e ../Makefile.package.settings) then
    sed -i -e '/^[ \t]*include.*LBM-IBB.*$/d' ../Makefile.package.settings
  fi

fi
