include(FogNpm)

# fog_report_library(SOURCE FOLDER): the plot library of the reports, by the lock file in SOURCE: script.js, style.css
# and licence.txt in FOLDER. None of them where npm cannot install it: fogcomp is built all the same then; its reports
# have all words and tables, and say that they have no plots.
function(fog_report_library source folder)
  fog_npm_ci("${source}" "${folder}" "reports will have no plots")
  set(package "${folder}/node_modules/uplot")
  if(EXISTS "${folder}/lock.sha256")
    configure_file("${package}/dist/uPlot.iife.min.js" "${folder}/script.js" COPYONLY)
    configure_file("${package}/dist/uPlot.min.css" "${folder}/style.css" COPYONLY)
    configure_file("${package}/LICENSE" "${folder}/licence.txt" COPYONLY)
  else()
    file(REMOVE "${folder}/script.js" "${folder}/style.css" "${folder}/licence.txt")
  endif()
endfunction()
